// The start of rays towards the light from a node (Structured/LightNodes.h), which takes the place of a vertex.
bool startsAtVertex(uint node, OUT(LightStart) start)
{
  uint row = uint(lightNodes.x);
  uint rows = uint(lightNodes.y);
  start.point = pointOfNode(uvec3(node % row, node / row % rows, node / row / rows));
  return true;
}
