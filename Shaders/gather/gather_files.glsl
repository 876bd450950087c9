// The contribution of a segment, by blend mode.
#if TETMARCH_EXTREME
#include "gather/extreme.glsl"
#elif TETMARCH_SUM
#include "gather/sum.glsl"
#elif TETMARCH_ISOSURFACES
#include "gather/isosurfaces.glsl"
#else
#if TETMARCH_ERROR_BOUND && !TETMARCH_EVEN_CUTS
#include "gather/order_error.glsl"
#endif
#include "gather/subsegment.glsl"
#if TETMARCH_LIT_COMPONENTS
#if TETMARCH_STRUCTURED
#include "structured/component_gradient.glsl"
#else
#include "tet/component_gradient.glsl"
#endif
#include "gather/component_light.glsl"
#endif
#if TETMARCH_INDEPENDENT
#include "gather/independent_components.glsl"
#elif TETMARCH_DEPENDENT
#include "gather/dependent_components.glsl"
#else
#include "gather/single_component.glsl"
#endif
#if TETMARCH_POINT_SAMPLED
#include "gather/segment_sampled.glsl"
#elif TETMARCH_EVEN_CUTS
#include "gather/segment_even.glsl"
#elif TETMARCH_POINT_SCALARS
#include "gather/segment_linear.glsl"
#else
#include "gather/segment_constant.glsl"
#endif
#if TETMARCH_CURVED_ERROR
#include "gather/curved_error.glsl"
#endif
#include "gather/composite.glsl"
#endif
