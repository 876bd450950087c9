// What a ray gathers of a tetrahedron, by blend mode.
#if TETMARCH_EXTREME
#include "gather/extreme.glsl"
#elif TETMARCH_SUM
#include "gather/sum.glsl"
#elif TETMARCH_ISOSURFACES
#include "gather/isosurfaces.glsl"
#else
#if TETMARCH_ERROR_BOUND
#include "gather/order_error.glsl"
#endif
#if TETMARCH_INDEPENDENT
#include "gather/independent_components.glsl"
#endif
#if TETMARCH_DEPENDENT
#include "gather/dependent_components.glsl"
#endif
#if TETMARCH_POINT_SCALARS
#include "gather/segment_linear.glsl"
#else
#include "gather/segment_constant.glsl"
#endif
#include "gather/composite.glsl"
#endif
