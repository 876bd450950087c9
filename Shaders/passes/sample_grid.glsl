// A grid of samples of a part of the picture. Sample i of an axis is in pixel min(i * spacing, last pixel): the last pixel is a
// sample at each spacing, and samples of one grid are those with even numbers of the next finer one.

uniform ivec2 lastSample; // of the grid
uniform ivec2 firstPixel; // of the part, in the picture
uniform ivec2 lastPixel;  // of the part, in it
uniform int spacing;      // of samples, in pixels

ivec2 pixelOfSample(ivec2 at) { return min(at * spacing, lastPixel); }
