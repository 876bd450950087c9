// Rays towards the light; to be included behind tet/traversal_files.glsl.
#include "light/extinction.glsl"
#include "tet/tet.glsl"
#include "tet/inside.glsl"
