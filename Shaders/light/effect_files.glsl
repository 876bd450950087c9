// Gradients and light, in the order in which their files use each other.
#if TETMARCH_SHOW_GRADIENTS
#include "light/gradient_color.glsl"
#endif
#if TETMARCH_SHADING
#include "light/light_source.glsl"
#if TETMARCH_SCATTERING
#include "light/scattering.glsl"
#endif
#if TETMARCH_SHADOWS
#include "light/shadows.glsl"
#endif
#include "light/lighting.glsl"
#endif
#if TETMARCH_LIT
#include "light/reflection.glsl"
#if TETMARCH_COMPOSITE
#include "light/lit_segment.glsl"
#endif
#endif
#include "light/shade.glsl"
