// Scalars that are not finite are stored as UNDRAWN_SCALAR; all others lie in 0..1. Cells that touch such a scalar are
// passed, or have a colour of their own.
bool isDrawn(real scalar) { return scalar < real(2); }
