// The starting point of rays from a node (Structured/LightNodes.h) towards the light; nodes correspond to vertices.
bool startsAtVertex(uint node, OUT(LightStart) start)
{
  uint row = uint(lightNodes.x);
  uint rows = uint(lightNodes.y);
  start.point = pointOfNode(uvec3(node % row, node / row % rows, node / row / rows));
  return true;
}
