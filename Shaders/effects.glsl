// The effects, in the order in which they use each other.
#if TETMARCH_SHOW_GRADIENTS
#include "gradient_color.glsl"
#endif
#if TETMARCH_SHADING
#include "light_source.glsl"
#if TETMARCH_SCATTERING
#include "scattering.glsl"
#endif
#if TETMARCH_SHADOWS
#include "shadows.glsl"
#endif
#include "lighting.glsl"
#endif
#if TETMARCH_LIT
#include "reflection.glsl"
#if TETMARCH_COMPOSITE
#include "lit_piece.glsl"
#endif
#endif
#include "shade.glsl"
#if TETMARCH_LIGHT_ERROR
#include "light_error.glsl"
#endif
