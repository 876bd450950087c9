// The common part of all marches: the traversal of the mesh, and the attributes of the volume.
#include "tet/cells.glsl"
#include "tet/edge_sign.glsl"
#include "march/ray.glsl"
#include "tet/vertex_attributes.glsl"
#include "march/stored_scalar.glsl"
#include "tet/face_intersection.glsl"
#if TETMARCH_CORNER_SCALARS
#include "tet/corner_scalars.glsl"
#endif
#include "march/linear_scalar.glsl"
#if TETMARCH_HIDDEN_CELLS
#include "march/hidden_cells.glsl"
#endif
#include "march/entry.glsl"
#if TETMARCH_BVH
#include "march/line_box.glsl"
#endif
#include "tet/boundary.glsl"
#if TETMARCH_ENTRY_LISTS
#include "tet/entry_lists.glsl"
#endif
#include "tet/traversal.glsl"
