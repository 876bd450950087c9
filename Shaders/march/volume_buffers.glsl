// What rays march through.
#if TETMARCH_STRUCTURED
#include "structured/lattice_buffers.glsl"
#else
#include "tet/mesh_buffers.glsl"
#endif
