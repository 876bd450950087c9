// What a ray gathers of a tetrahedron, by blend mode.
#if TETMARCH_EXTREME
#include "gather_extreme.glsl"
#elif TETMARCH_SUM
#include "gather_sum.glsl"
#elif TETMARCH_ISOSURFACES
#include "gather_isosurfaces.glsl"
#else
#if TETMARCH_ERROR_BOUND
#include "order_error.glsl"
#endif
#if TETMARCH_INDEPENDENT
#include "mixture.glsl"
#endif
#if TETMARCH_DEPENDENT
#include "tint.glsl"
#endif
#if TETMARCH_POINT_SCALARS
#include "segment_linear.glsl"
#else
#include "segment_constant.glsl"
#endif
#include "gather_composite.glsl"
#endif
