// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// The results of a vtkTetMarchFirstPicture.
#ifndef vtkTetMarchFirstPictureInternals_h
#define vtkTetMarchFirstPictureInternals_h

#include "FirstPicture/Crossings.h"
#include "FirstPicture/DrawnArray.h"
#include "FirstPicture/PicturePlane.h"
#include "Input/MadeGrids.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkTetMarchFirstPicture.h"

#include <string>
#include <vector>

struct vtkTetMarchFirstPicture::Internals
{
  vtkSmartPointer<vtkDataObject> Data;
  tetmarch::MadeGrids Made;
  vtkSmartPointer<vtkDataObject> Drawn; // with grids of leaves in place of trees; set by check()
  vtkMTimeType Time = 0; // of the data when it was checked, and its blocks were listed
  bool IsChecked = false;
  std::string Fault; // of the data
  std::vector<vtkSmartPointer<vtkDataSet>> Owned;
  std::vector<vtkDataSet*> Blocks; // all of these
  bool Lattices = false;           // images and rectilinear grids, all of them, not adaptive
  std::vector<tetmarch::Vector3> Outline;
  tetmarch::PicturePlane Plane;
  tetmarch::DrawnArray Chosen;
  bool HasCrossings = false;
  tetmarch::Crossings Crossings; // of the chosen array
  bool HasFunctions = false;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkPiecewiseFunction> Opacity;

  void forget()
  {
    this->IsChecked = false;
    this->Fault.clear();
    this->Drawn = nullptr;
    this->Blocks.clear();
    this->Owned.clear();
    this->Outline.clear();
    this->Chosen = {};
    this->HasCrossings = false;
    this->Crossings = {};
    this->HasFunctions = false;
  }

  std::string check();
  void findBlocks();
  // The visible part of images and rectilinear grids; all if nothing is visible, and of other data.
  std::vector<tetmarch::Vector3> findShown(vtkPiecewiseFunction* opacity, bool structuredLaw) const;
};

#endif
