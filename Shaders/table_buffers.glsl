// The transfer functions in texture buffers; see integral_table.glsl.
uniform samplerBuffer tableValueBuffer;
uniform usamplerBuffer tableIntegralBuffer;
uniform usamplerBuffer tableSquareBuffer;
uniform int tableSize;
uniform float tableScale; // from a stored scalar to a position in the table
uniform float tableOffset;
uniform vec4 tableIntegralUnit;
uniform float tableSquareUnit;
uniform float integrationTolerance;
uniform int mostTrials; // pieces that a segment may be tried in
uniform float leastTransmittance;

vec4 fetchTableValue(int i) { return texelFetch(tableValueBuffer, i); }
uvec4 fetchTableIntegral(int i) { return texelFetch(tableIntegralBuffer, i); }
uint fetchTableSquareIntegral(int i) { return texelFetch(tableSquareBuffer, i).x; }
