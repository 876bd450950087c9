// Rays towards the light, behind what every march is made of.
#include "light/extinction.glsl"
#include "tet/tet.glsl"
#include "tet/inside.glsl"
