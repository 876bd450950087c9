// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteKinds.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRandomHyperTreeGridSource.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLHyperTreeGridWriter.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <QFile>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Around = 48;
constexpr int Across = 10; // outwards, and upwards

using Field = std::function<double(double x, double y, double z)>;
using Corners = std::array<vtkIdType, 8>;

double Waves(double x, double y, double z)
{
  return std::sin(3.0 * x + y) * std::cos(4.0 * y) + std::sin(5.0 * z);
}

enum class Cells
{
  Hexahedra,
  Mixed
};

/// A ring of radius 1 to 2 and height 1, cell by cell.
class Ring
{
public:
  Ring(Cells cells, const Field& field)
  {
    this->AddPoints();
    for (int i = 0; i < Around; ++i)
    {
      for (int j = 0; j < Across; ++j)
      {
        for (int k = 0; k < Across; ++k)
        {
          const int kind = cells == Cells::Mixed ? 4 * i / Around : 0;
          this->AddHexahedron(this->GetCorners(i, j, k), kind);
        }
      }
    }
    vtkNew<vtkDoubleArray> values;
    values->SetName("waves");
    for (vtkIdType p = 0; p < this->Points->GetNumberOfPoints(); ++p)
    {
      const double* at = this->Points->GetPoint(p);
      values->InsertNextValue(field(at[0], at[1], at[2]));
    }
    this->Grid->SetPoints(this->Points);
    this->Grid->GetPointData()->SetScalars(values);
  }

  vtkUnstructuredGrid* GetGrid() { return this->Grid; }

private:
  void AddPoints()
  {
    for (int i = 0; i < Around; ++i)
    {
      for (int j = 0; j <= Across; ++j)
      {
        for (int k = 0; k <= Across; ++k)
        {
          const double angle = 2.0 * Pi * i / Around;
          const double radius = 1.0 + double(j) / Across;
          this->Points->InsertNextPoint(
            radius * std::cos(angle), radius * std::sin(angle), double(k) / Across);
        }
      }
    }
  }

  static vtkIdType GetPoint(int i, int j, int k)
  {
    return (vtkIdType(i % Around) * (Across + 1) + j) * (Across + 1) + k;
  }

  static Corners GetCorners(int i, int j, int k)
  {
    return { GetPoint(i, j, k), GetPoint(i, j + 1, k), GetPoint(i + 1, j + 1, k),
      GetPoint(i + 1, j, k), GetPoint(i, j, k + 1), GetPoint(i, j + 1, k + 1),
      GetPoint(i + 1, j + 1, k + 1), GetPoint(i + 1, j, k + 1) };
  }

  void Add(int type, const std::vector<vtkIdType>& points)
  {
    this->Grid->InsertNextCell(type, static_cast<vtkIdType>(points.size()), points.data());
  }

  void AddHexahedron(const Corners& c, int kind)
  {
    if (kind == 0)
    {
      this->Add(VTK_HEXAHEDRON, { c.begin(), c.end() });
    }
    else if (kind == 1)
    {
      this->Add(VTK_WEDGE, { c[0], c[2], c[1], c[4], c[6], c[5] });
      this->Add(VTK_WEDGE, { c[0], c[3], c[2], c[4], c[7], c[6] });
    }
    else
    {
      this->AddAroundCentre(c, kind == 2);
    }
  }

  /// Six pyramids, or twelve tetrahedra.
  void AddAroundCentre(const Corners& c, bool pyramids)
  {
    std::array<double, 3> sum{};
    for (const vtkIdType corner : c)
    {
      const double* at = this->Points->GetPoint(corner);
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += at[axis] / 8.0;
      }
    }
    const vtkIdType centre = this->Points->InsertNextPoint(sum.data());
    const int faces[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 1, 5, 6, 2 },
      { 2, 6, 7, 3 }, { 3, 7, 4, 0 } };
    for (const auto& face : faces)
    {
      const vtkIdType q[4] = { c[face[0]], c[face[1]], c[face[2]], c[face[3]] };
      if (pyramids)
      {
        this->Add(VTK_PYRAMID, { q[0], q[1], q[2], q[3], centre });
        continue;
      }
      // Neighbours share the diagonal through the point with the least number.
      const auto least = std::min_element(q, q + 4) - q;
      this->Add(VTK_TETRA, { q[least], q[(least + 1) % 4], q[(least + 2) % 4], centre });
      this->Add(VTK_TETRA, { q[least], q[(least + 2) % 4], q[(least + 3) % 4], centre });
    }
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkUnstructuredGrid> Grid;
};

QString WriteGrid(const QString& path, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetFileName(path.toUtf8().constData());
  writer->SetInputData(grid);
  writer->Write();
  return path;
}
} // namespace

namespace tetmarch
{

QString WriteMixedCells(const QString& folder)
{
  return WriteGrid(
    folder + QStringLiteral("/mixed_cells.vtu"), Ring(Cells::Mixed, Waves).GetGrid());
}

QString WriteCellScalars(const QString& folder)
{
  Ring ring(Cells::Hexahedra, Waves);
  vtkUnstructuredGrid* grid = ring.GetGrid();
  vtkNew<vtkDoubleArray> values;
  values->SetName("heat");
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    double b[6];
    grid->GetCellBounds(cell, b);
    values->InsertNextValue(Waves((b[0] + b[1]) / 2, (b[2] + b[3]) / 2, (b[4] + b[5]) / 2));
  }
  grid->GetPointData()->Initialize();
  grid->GetCellData()->SetScalars(values);
  return WriteGrid(folder + QStringLiteral("/cell_scalars.vtu"), grid);
}

QString WriteBlocks(const QString& folder)
{
  constexpr int points = 41;
  vtkNew<vtkImageData> image;
  image->SetDimensions(points, points, points / 2);
  image->SetOrigin(2.5, -1.0, 0.0);
  image->SetSpacing(0.05, 0.05, 0.05);
  vtkNew<vtkDoubleArray> values;
  values->SetName("waves");
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const double* at = image->GetPoint(p);
    values->InsertNextValue(Waves(at[0], at[1], at[2]));
  }
  image->GetPointData()->SetScalars(values);
  Ring ring(Cells::Hexahedra, Waves);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, ring.GetGrid());
  blocks->SetBlock(1, image);
  const QString path = folder + QStringLiteral("/blocks.vtm");
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  writer->SetFileName(path.toUtf8().constData());
  writer->SetInputData(blocks);
  writer->Write();
  return path;
}

QString WriteTree(const QString& folder)
{
  vtkNew<vtkRandomHyperTreeGridSource> source;
  source->SetDimensions(5, 5, 5);
  source->SetMaxDepth(4);
  source->SetSeed(3);
  const QString path = folder + QStringLiteral("/tree.htg");
  vtkNew<vtkXMLHyperTreeGridWriter> writer;
  writer->SetFileName(path.toUtf8().constData());
  writer->SetInputConnection(source->GetOutputPort());
  writer->Write();
  return path;
}

QString WriteTimeSeries(const QString& folder)
{
  QString list = QStringLiteral("<VTKFile type=\"Collection\" version=\"0.1\"><Collection>\n");
  for (int step = 0; step < 5; ++step)
  {
    const QString name = QStringLiteral("waves_%1.vtu").arg(step);
    const auto moved = [step](double x, double y, double z)
    { return Waves(x + 0.3 * step, y, z + 0.1 * step); };
    WriteGrid(folder + QLatin1Char('/') + name, Ring(Cells::Hexahedra, moved).GetGrid());
    list += QStringLiteral("<DataSet timestep=\"%1\" part=\"0\" file=\"%2\"/>\n")
              .arg(0.25 * step)
              .arg(name);
  }
  const QString path = folder + QStringLiteral("/waves.pvd");
  QFile file(path);
  if (file.open(QIODevice::WriteOnly))
  {
    file.write((list + QStringLiteral("</Collection></VTKFile>\n")).toUtf8());
  }
  return path;
}

} // namespace tetmarch
