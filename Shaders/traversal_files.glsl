// What every march is made of: the ways of a ray through the mesh, and what the volume is there.
#include "edge_sign.glsl"
#include "ray.glsl"
#include "crossing.glsl"
#include "boundary.glsl"
#include "way.glsl"
#if !TETMARCH_ISOSURFACES
#include "integral_table.glsl"
#endif
#if TETMARCH_INDEPENDENT
#include "mixture.glsl"
#endif
#if TETMARCH_GRADIENT_OPACITY
#include "gradient_opacity.glsl"
#endif
