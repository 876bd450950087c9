// The common part of all marches: the traversal of the lattice, and the attributes of the volume.
#include "march/ray.glsl"
#include "march/entry.glsl"
#include "march/stored_scalar.glsl"
#include "march/linear_scalar.glsl"
#if TETMARCH_HIDDEN_CELLS
#include "march/hidden_cells.glsl"
#endif
#include "structured/lattice.glsl"
#if TETMARCH_LEAF_CELLS
#include "structured/octree.glsl"
#endif
#if TETMARCH_POINT_SAMPLED
#include "structured/ray_samples.glsl"
#endif
#if TETMARCH_POINT_SCALARS
#include "structured/trilinear.glsl"
#endif
#if TETMARCH_BENT_COMPONENTS
#include "structured/extra_cubics.glsl"
#endif
#if TETMARCH_VERTEX_LIGHT
#include "structured/light_nodes.glsl"
#endif
#if TETMARCH_EFFECTS || TETMARCH_LIT_COMPONENTS
#include "structured/attributes.glsl"
#endif
#include "structured/traversal.glsl"
