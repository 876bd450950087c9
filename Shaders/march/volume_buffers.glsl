// The data of the volume.
#if TETMARCH_STRUCTURED
#include "structured/lattice_buffers.glsl"
#if TETMARCH_POINT_SAMPLED
#include "structured/sample_buffers.glsl"
#endif
#else
#include "tet/mesh_buffers.glsl"
#if TETMARCH_ENTRY_LISTS
#include "tet/entry_list_buffers.glsl"
#endif
#if TETMARCH_VISIBLE_PART
#include "tet/visible_part_buffers.glsl"
#endif
#endif
