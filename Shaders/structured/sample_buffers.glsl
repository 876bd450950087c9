// The distances at which rays sample the lattice. Bound by GL/MarchPass.
uniform float sampleStep;      // depth between samples
uniform float samplesPerDepth; // 1 over that
uniform vec2 sampleShift;      // of the first sample, in steps: scale of the pixel's jitter and offset
