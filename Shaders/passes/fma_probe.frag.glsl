// Whether fma rounds once: (1 + 2^-12)^2 - its rounded square is 2^-24, and 0 if the product is rounded.
#extension GL_ARB_gpu_shader5 : require

//VTK::Output::Dec

uniform float onePlus;

void main()
{
  precise float square = onePlus * onePlus;
  precise float rest = fma(onePlus, onePlus, -square);
  gl_FragData[0] = vec4(rest, square, 0.0, 1.0);
}
