// What every march is made of: the ways of a ray through the mesh, and what the volume is there.
#include "tet/edge_sign.glsl"
#include "march/ray.glsl"
#include "tet/face_intersection.glsl"
#include "tet/boundary.glsl"
#include "tet/traversal.glsl"
#if !TETMARCH_ISOSURFACES
#include "tables/integral_table.glsl"
#endif
#if TETMARCH_GRADIENT_OPACITY
#include "tables/gradient_opacity.glsl"
#endif
