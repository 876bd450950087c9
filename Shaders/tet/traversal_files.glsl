// What every march is made of: the traversal of the mesh, and what the volume is there.
#include "tet/edge_sign.glsl"
#include "march/ray.glsl"
#include "tet/vertex_attributes.glsl"
#include "tet/face_intersection.glsl"
#include "tet/linear_scalar.glsl"
#if TETMARCH_HIDDEN_CELLS
#include "tet/hidden_cells.glsl"
#endif
#include "tet/boundary.glsl"
#include "tet/traversal.glsl"
#if TETMARCH_USES_TABLES
#include "tables/integral_table.glsl"
#endif
#if TETMARCH_GRADIENT_OPACITY
#include "tables/gradient_opacity.glsl"
#endif
