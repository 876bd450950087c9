// Uniforms of the blend modes; see the files of gather/ and Appearance/Blending.h. Scalars are as stored, 0..1.
#if TETMARCH_EXTREME
uniform float extremeSign; // 1: maximum, -1: minimum
#elif TETMARCH_SUM
uniform bool averages;     // averages are shown, else sums
uniform vec2 averageRange; // of the included scalars
#elif TETMARCH_ISOSURFACES
uniform int isoSurfaceCount;
uniform float isoValue[MOST_ISOSURFACES]; // ascending, distinct
uniform vec4 isoColor[MOST_ISOSURFACES];  // colour and opacity of each surface

float fetchIsoValue(int surface) { return isoValue[surface]; }
vec4 fetchIsoColor(int surface) { return isoColor[surface]; }
#endif
