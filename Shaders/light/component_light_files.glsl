// Light of independent components, in the order in which the files use each other.
#include "light/light_source.glsl"
#include "light/lighting.glsl"
