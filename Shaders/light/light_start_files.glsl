// Starting points of rays towards the light; include after march/traversal_files.glsl.
#if TETMARCH_STRUCTURED
#include "structured/light_start.glsl"
#else
#include "tet/tet.glsl"
#include "tet/light_start.glsl"
#endif
