// Clipping planes and the regions that cropping leaves; Rays/Clipping.h.
uniform int clippingPlaneCount;
uniform vec4 clippingPlane[MOST_CLIPPING_PLANES]; // unit normal n, d: where n x + d >= 0 the volume is left
#if TETMARCH_CROPPED
uniform vec3 croppingLow; // two planes across each axis
uniform vec3 croppingHigh;
uniform int croppingFlags; // a bit for each of the 27 regions: it is left
#endif

vec4 fetchClippingPlane(int i) { return clippingPlane[i]; }
