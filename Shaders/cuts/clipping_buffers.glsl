// Clipping planes, and what cropping leaves; Rays/Clipping.h.
uniform int clippingPlaneCount;
uniform vec4 clippingPlane[MOST_CLIPPING_PLANES]; // unit normal n, d: n x + d >= 0 is left
#if TETMARCH_CROPPED
uniform vec3 croppingLow; // two planes across each axis
uniform vec3 croppingHigh;
uniform int croppingFlags; // a bit for each region between them that is left
#endif

vec4 fetchClippingPlane(int i) { return clippingPlane[i]; }
