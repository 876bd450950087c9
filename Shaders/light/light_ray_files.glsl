// Rays towards the light; include after march/traversal_files.glsl.
#include "light/light_start_files.glsl"
#include "light/light_range.glsl"
#if TETMARCH_STRUCTURED
#include "structured/transmittance.glsl"
#else
#include "tet/extinction.glsl"
#include "tet/inside.glsl"
#endif
