// Scalars that are not finite are stored as UNDRAWN_SCALAR; all others are in 0..1. Cells with such a scalar are
// skipped, or drawn in the NaN colour.
bool isDrawn(real scalar) { return scalar < real(2); }
