// A face between two media that may be elsewhere on the ray (gather/curved_error.glsl).

struct ShiftedFace
{
  real depth;
  real scalar; // before it
  real shift;  // by which it may be elsewhere, in scalar opacity unit distances
  vec4 medium; // C and tau before it; tau is 0 outside
  real bright; // maximum brightness of a colour of 1 on both sides
};

CONSTANT vec4 NO_MEDIUM = vec4(real(0), real(0), real(0), real(0));

// A face before the volume.
ShiftedFace noFace()
{
  ShiftedFace face;
  face.depth = -NO_DEPTH;
  face.scalar = real(0);
  face.shift = real(0);
  face.medium = NO_MEDIUM;
  face.bright = real(0);
  return face;
}

// Upper bound of the error of a channel, with this medium behind the face. If it is further ahead, less of what is
// before it absorbs its light.
real shiftedFaceError(ShiftedFace face, vec4 behind, real transmittance)
{
  real shift = min(face.shift, real(1) / TINY);
  vec3 rise = abs(vec3(behind.x - face.medium.x, behind.y - face.medium.y, behind.z - face.medium.z));
  real ofColors = min(face.medium.w, behind.w) * max(rise.x, max(rise.y, rise.z));
  real seen = min(transmittance * exp(min(face.medium.w * shift, real(80))), real(1));
  real error = seen * min((abs(behind.w - face.medium.w) + ofColors) * shift, real(1));
#if TETMARCH_LIT
  // The background and reflections of white surfaces are assumed to be at most 1.
  error = error * (real(1) + face.bright);
#endif
  return error;
}
