// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WriteGrids.h"

#include "Fields.h"
#include "QuadraticGrids.h"

#include "vtkAppendFilter.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <QFile>

#include <cmath>

QString tetmarch::WriteLattice(const QString& path, int cells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells + 1, cells + 1, cells + 1);
  image->SetSpacing(1.0 / cells, 1.0 / cells, 1.0 / cells);
  vtkNew<vtkDoubleArray> waves;
  waves->SetName("waves");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* at = image->GetPoint(i);
    waves->InsertNextValue(std::sin(9.0 * at[0]) * std::cos(7.0 * at[1]) + at[2]);
  }
  image->GetPointData()->SetScalars(waves);
  vtkNew<vtkAppendFilter> grid;
  grid->AddInputData(image);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputConnection(grid->GetOutputPort());
  writer->SetFileName(path.toUtf8().constData());
  writer->SetCompressorTypeToNone();
  writer->Write();
  return path;
}

QString tetmarch::WriteCurvedCells(const QString& path)
{
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(testing::quadraticHexLattice(2, 0.1, testing::radialField()));
  writer->SetFileName(path.toUtf8().constData());
  writer->Write();
  return path;
}

QString tetmarch::WriteSteps(const QString& path)
{
  QString ramps;
  for (int step = 1; step <= 3; ++step)
  {
    ramps += QStringLiteral("<DataArray type=\"Float64\" Name=\"ramp\" format=\"ascii\" "
                            "TimeStep=\"%1\">0 %2 0 %2 0 %2 0 %2</DataArray>")
               .arg(step - 1)
               .arg(step);
  }
  QFile file(path);
  if (file.open(QIODevice::WriteOnly))
  {
    file.write(QStringLiteral(
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">"
      "<UnstructuredGrid TimeValues=\"0 1 2\"><Piece NumberOfPoints=\"8\" NumberOfCells=\"1\">"
      "<PointData>%1</PointData><Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" "
      "format=\"ascii\">0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1</DataArray></Points>"
      "<Cells><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 2 3 4 5 6 7"
      "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">8</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">11</DataArray></Cells>"
      "</Piece></UnstructuredGrid></VTKFile>")
                 .arg(ramps)
                 .toUtf8());
  }
  return path;
}
