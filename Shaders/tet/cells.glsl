// The tetrahedra: stored, or those of a curvilinear grid.
#if TETMARCH_CURVILINEAR
#include "tet/curvilinear_cells.glsl"
#else
#include "tet/packed_cells.glsl"
#endif
