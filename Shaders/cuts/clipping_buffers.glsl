// Clipping planes and the regions that remain after cropping; View/Clipping.h.
uniform int clippingPlaneCount;
uniform vec4 clippingPlane[MOST_CLIPPING_PLANES]; // unit normal n, d: the volume remains where n x + d >= 0
#if TETMARCH_CROPPED
uniform vec3 croppingLow; // two planes perpendicular to each axis
uniform vec3 croppingHigh;
uniform int croppingFlags; // one bit for each of the 27 regions: 1 if it remains
#endif

vec4 fetchClippingPlane(int i) { return clippingPlane[i]; }
