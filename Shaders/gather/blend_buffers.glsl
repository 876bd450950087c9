// What the blend modes read; see gather_....glsl and Appearance/Blending.h. Scalars as they are stored, 0..1.
#if TETMARCH_EXTREME
uniform float extremeSign; // 1: maximum, -1: minimum
#elif TETMARCH_SUM
uniform bool averages;     // else sums are shown
uniform vec2 averageRange; // scalars that count
#elif TETMARCH_ISOSURFACES
uniform int isoSurfaceCount;
uniform float isoValue[MOST_ISOSURFACES]; // ascending, none twice
uniform vec4 isoColor[MOST_ISOSURFACES];  // colour and opacity there

float fetchIsoValue(int surface) { return isoValue[surface]; }
vec4 fetchIsoColor(int surface) { return isoColor[surface]; }
#endif
