// Rays towards the light, behind what every march is made of.
#include "extinction.glsl"
#include "tet.glsl"
#include "inside.glsl"
