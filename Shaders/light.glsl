// What light makes of the volume at a point: its own colour is multiplied, and highlights are added.

struct Light
{
  vec3 diffuse;  // factor of the volume's own colour
  vec3 specular; // is added to it
};

Light noLight()
{
  Light light;
  light.diffuse = vec3(real(0), real(0), real(0));
  light.specular = light.diffuse;
  return light;
}

Light addLight(Light p, Light q)
{
  p.diffuse = p.diffuse + q.diffuse;
  p.specular = p.specular + q.specular;
  return p;
}

Light dimLight(Light p, real factor)
{
  p.diffuse = p.diffuse * factor;
  p.specular = p.specular * factor;
  return p;
}

Light mixLight(Light p, Light q, real share)
{
  p.diffuse = p.diffuse + (q.diffuse - p.diffuse) * share;
  p.specular = p.specular + (q.specular - p.specular) * share;
  return p;
}

// The light at a point, by the way it has come.
struct Illumination
{
  Light direct; // all that is known
#if TETMARCH_HEADLIGHT_SHADOWS
  Light head; // along the ray, before it was absorbed on its way: as much as comes back
#endif
#if TETMARCH_SAMPLED_SHADOWS
  Light beam[SHADOW_CHANNELS]; // from each light that casts shadows, before it was absorbed on its way
#endif
};

Illumination noIllumination()
{
  Illumination lit;
  lit.direct = noLight();
#if TETMARCH_HEADLIGHT_SHADOWS
  lit.head = noLight();
#endif
#if TETMARCH_SAMPLED_SHADOWS
  for (int channel = 0; channel < SHADOW_CHANNELS; ++channel)
  {
    lit.beam[channel] = noLight();
  }
#endif
  return lit;
}

Illumination mixIllumination(Illumination p, Illumination q, real share)
{
  p.direct = mixLight(p.direct, q.direct, share);
#if TETMARCH_HEADLIGHT_SHADOWS
  p.head = mixLight(p.head, q.head, share);
#endif
#if TETMARCH_SAMPLED_SHADOWS
  for (int channel = 0; channel < SHADOW_CHANNELS; ++channel)
  {
    p.beam[channel] = mixLight(p.beam[channel], q.beam[channel], share);
  }
#endif
  return p;
}
