// The transfer functions in texture buffers; see tables/integral_table.glsl. In GLSL ES the value of a global variable
// must be constant: there the uniforms themselves are read.
#if TETMARCH_USES_TABLES
uniform samplerBuffer tableValueBuffer;
uniform usamplerBuffer tableIntegralBuffer;
#endif
#if TETMARCH_ONE_TABLE
uniform int tableSize;
uniform vec4 givenIntegralUnit;
#if TETMARCH_ES
#define tableIntegralUnit givenIntegralUnit
#else
vec4 tableIntegralUnit = KEPT(givenIntegralUnit);
#endif
#endif
#if TETMARCH_OPACITY_TABLE
uniform float tableScale; // factor from a stored scalar to a position in the table
uniform float tableOffset;
#endif
#if TETMARCH_COMPONENTS
uniform int tableFirst[MOST_COMPONENTS]; // first entries of the consecutive tables
uniform int tableSizes[MOST_COMPONENTS];
uniform vec4 tableIntegralUnits[MOST_COMPONENTS];
uniform vec2 tablePlace[MOST_COMPONENTS]; // scale and offset
#endif
#if TETMARCH_INDEPENDENT
uniform int componentCount;
uniform vec4 componentFactor; // of their extinctions
#endif
#if TETMARCH_ACCUMULATES_OPACITY
uniform float givenTolerance;
#if TETMARCH_ES
#define errorTolerance givenTolerance
#else
float errorTolerance = KEPT(givenTolerance); // of a channel of a pixel
#endif
#endif
#if TETMARCH_TRANSPARENT_RANGES
uniform vec4 givenTransparentRanges;
// Positions in the table: below x, above y, and from z to w.
#if TETMARCH_ES
#define transparentRanges givenTransparentRanges
#else
vec4 transparentRanges = KEPT(givenTransparentRanges);
#endif
#endif
#if TETMARCH_CONSTANT_COLOR
uniform vec3 constantColor; // replaces that of the table
#endif
#if TETMARCH_NAN_SHOWN
uniform vec4 nanColor; // of scalars that are not finite, and their extinction
#endif
#if TETMARCH_VARIATIONS
uniform samplerBuffer tableVariationBuffer;
#endif
#if TETMARCH_ADAPTIVE
uniform int givenTrials;
#if TETMARCH_ES
#define mostTrials givenTrials
#else
int mostTrials = KEPT_INT(givenTrials); // of subsegments of a segment, before any is accepted
#endif
#endif

#if TETMARCH_USES_TABLES
vec4 fetchTableValue(int i) { return BUFFER_TEXEL(tableValueBuffer, i); }
uvec4 fetchTableIntegral(int i) { return BUFFER_TEXEL(tableIntegralBuffer, i); }
#endif
#if TETMARCH_COMPONENTS
int fetchTableFirst(int table) { return tableFirst[table]; }
int fetchTableSize(int table) { return tableSizes[table]; }
vec4 fetchTableIntegralUnit(int table) { return tableIntegralUnits[table]; }
vec2 fetchTablePlace(int table) { return tablePlace[table]; }
#endif
#if TETMARCH_VARIATIONS
#if TETMARCH_EXTINCTION_VARIATION
vec2 fetchTableVariations(int i) { return BUFFER_TEXEL(tableVariationBuffer, i).xy; } // of colour and extinction
#if TETMARCH_SLOPE_VARIATION || TETMARCH_CURVED_ERROR
vec2 fetchTableSlopeVariations(int i) { return BUFFER_TEXEL(tableVariationBuffer, i).zw; } // of extinction and of C tau
#endif
#else
float fetchTableVariation(int i) { return BUFFER_TEXEL(tableVariationBuffer, i).x; }
#endif
#endif
