// The march of the picture, in the order in which its files use each other.
#include "traversal_files.glsl"
#if TETMARCH_LIT
#include "light.glsl"
#endif
#include "radiance.glsl"
#if TETMARCH_EFFECTS
#include "effects.glsl"
#endif
#if TETMARCH_POINT_SCALARS
#if TETMARCH_ERROR_BOUND
#include "order_error.glsl"
#endif
#include "segment_linear.glsl"
#else
#include "segment_constant.glsl"
#endif
#if TETMARCH_SAMPLED_SHADOWS
#include "tet.glsl"
#endif
#if TETMARCH_CROPPED
#include "cropping.glsl"
#endif
#include "march.glsl"
