// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchFirstPicture
 * @brief   Default array, transfer functions and camera for a first picture of data
 *
 * It chooses an array, transfer functions, a unit distance and a camera from the data, so that a
 * first picture is neither empty nor opaque throughout. It needs no OpenGL and no window; its
 * methods can be called in any thread. The choice is deterministic. The input is an unstructured
 * grid, an image, a rectilinear or curvilinear grid, or a tree of such blocks.
 *
 * @code{.cpp}
 * vtkNew<vtkTetMarchFirstPicture> first;
 * first->SetInputData(grid);
 * if (first->Choose())
 * {
 *   first->ApplyTo(volume); // its property; the array and the component of its mapper
 *   first->PlaceCamera(renderer->GetActiveCamera(), 16.0 / 9.0);
 * }
 * @endcode
 *
 * Array: with several blocks, arrays of all blocks come first. Among these, physical values come
 * before numbers of cells, blocks or materials, and these before constant arrays; points come
 * before cells, and one component before several, whose magnitude is drawn.
 *
 * Range: the 2nd to the 98th percentile. Background: the peak of the histogram if there is one,
 * else the low end of the range. Opacity: 0 at the background of images, nearly 0 at that of
 * meshes; from there to the ends of the range it rises with a power of the distance. Unit distance:
 * half of the covered pixels have an opacity above 0.5, and at most one in 20 above 0.97. Power:
 * from 0.5 to 2, the one with the maximum entropy of the picture's opacities.
 *
 * Every method that returns a bool returns false after an error.
 */
#ifndef vtkTetMarchFirstPicture_h
#define vtkTetMarchFirstPicture_h

#include "vtkObject.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For what is found of the data
#include <string> // For names

class vtkCamera;
class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataObject;
class vtkPiecewiseFunction;
class vtkStringArray;
class vtkTable;
class vtkVolume;

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchFirstPicture : public vtkObject
{
public:
  static vtkTetMarchFirstPicture* New();
  vtkTypeMacro(vtkTetMarchFirstPicture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Associations
  {
    ANY = -1,
    POINTS = 0, // as vtkDataObject::FIELD_ASSOCIATION_POINTS
    CELLS = 1   // as vtkDataObject::FIELD_ASSOCIATION_CELLS
  };

  enum OpacityLaws
  {
    OF_THE_DATA = -1,
    UNSTRUCTURED = 0, // as vtkTetMarchSettings::UNSTRUCTURED
    STRUCTURED = 1    // as vtkTetMarchSettings::STRUCTURED
  };

  //@{
  /**
   * The data; null by default. Other or modified data discard the previous choice.
   */
  void SetInputData(vtkDataObject* data);
  vtkDataObject* GetInputData();
  //@}

  /**
   * Whether the data are valid: cells refer to existing points, coordinates are finite, arrays
   * match the dimensions, and so on. All methods that read the data call this first. The error is
   * that of the mapper; for a tree, that of the first invalid block. The result is kept until the
   * data are modified.
   */
  bool CheckData();

  /**
   * List all faults of the data, one per value: in the points and cells of each block, and arrays
   * that do not have one tuple per point or cell. Empty if there are none.
   */
  bool ListFaults(vtkStringArray* faults);

  //@{
  /**
   * The name of the array. Empty, the default: it is chosen.
   */
  void SetArrayName(const std::string& name);
  std::string GetArrayName() const;
  //@}

  //@{
  /**
   * The association of the array: POINTS, CELLS or ANY, the default: points, then cells; but cells
   * if all blocks have it there and some lack it on points.
   */
  vtkSetClampMacro(ArrayAssociation, int, ANY, CELLS);
  vtkGetMacro(ArrayAssociation, int);
  //@}

  //@{
  /**
   * The component, from 0; -1: the magnitude; -2, the default: the first component of an array set
   * by name, else the magnitude.
   */
  vtkSetClampMacro(Component, int, -2, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  //@}

  //@{
  /**
   * The range in the array's unit. The default, (1, 0), or any range whose first number isn't below
   * the second: it is chosen.
   */
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  //@}

  //@{
  /**
   * The opacity law, see vtkTetMarchSettings::SetOpacityLaw. OF_THE_DATA, the default: STRUCTURED
   * for images and rectilinear grids, UNSTRUCTURED for all others, adaptive meshes among them.
   */
  vtkSetClampMacro(OpacityLaw, int, OF_THE_DATA, STRUCTURED);
  vtkGetMacro(OpacityLaw, int);
  //@}

  //@{
  /**
   * Choose the array; transfer functions and unit distance; or both. ChooseTransferFunctions()
   * chooses an array first if there is none.
   */
  bool ChooseArray();
  bool ChooseTransferFunctions();
  bool Choose();
  //@}

  /**
   * Choose only the unit distance, for the given opacity function.
   */
  bool ChooseUnitDistance(vtkPiecewiseFunction* opacity);

  //@{
  /**
   * The chosen array, in the first block that has it, or null; POINTS or CELLS; its component, -1:
   * the magnitude; its range over all blocks, (1, 0) if no value is finite.
   */
  vtkDataArray* GetChosenArray();
  int GetChosenAssociation() const;
  int GetChosenComponent() const;
  void GetDataRange(double range[2]) VTK_SIZEHINT(2);
  //@}

  //@{
  /**
   * The chosen range of values, and the transparent value.
   */
  vtkGetVector2Macro(ChosenRange, double);
  vtkGetMacro(Background, double);
  //@}

  //@{
  /**
   * The chosen functions and unit distance, which ApplyTo() sets. The functions are owned by this
   * object; they can be changed, and are overwritten by the next choice. The unit distance, above
   * 0, is in units of the data's coordinates.
   */
  vtkColorTransferFunction* GetColor();
  vtkPiecewiseFunction* GetOpacity();
  vtkSetClampMacro(UnitDistance, double, 1e-300, VTK_DOUBLE_MAX);
  vtkGetMacro(UnitDistance, double);
  //@}

  /**
   * The choice in one line: "temperature on points, 293.1 to 913.2".
   */
  std::string Describe();

  /**
   * All arrays that can be drawn, one per row: name, association ("points", "cells"), type,
   * components, minimum and maximum (of the magnitude if there are several components; NaN if no
   * value is finite), and kind ("values", "numbers" of cells, blocks or the like, "constant", or
   * "not finite"). Arrays that do not have one tuple per point or cell are left out: see
   * ListFaults().
   */
  bool ListArrays(vtkTable* arrays);

  /**
   * Apply the choice to a volume: colour, opacity and unit distance of its property; array and
   * component of its mapper, if it has one; the opacity law, if the mapper is one of TetMarch.
   */
  bool ApplyTo(vtkVolume* volume);

  //@{
  /**
   * Place the camera such that the silhouette of the data just fits into a picture of that width /
   * height, above 0, in perspective and in parallel projection: obliquely, z up; flat data from the
   * broad side. For images and rectilinear grids, which are mostly transparent, the visible part by
   * GetOpacity() fits into the picture if transfer functions were chosen; the whole box if
   * FitWholeData is on (off by default).
   */
  bool PlaceCamera(vtkCamera* camera, double aspect);
  vtkSetMacro(FitWholeData, bool);
  vtkGetMacro(FitWholeData, bool);
  vtkBooleanMacro(FitWholeData, bool);
  //@}

  /**
   * Move the camera, which keeps its direction, such that the data just fit into a picture of that
   * width / height, above 0, as by PlaceCamera(). The volume's matrix places the data in the world,
   * and its opacity function says what is visible. The view up must not be parallel to the
   * direction. An array is chosen first if there is none.
   */
  bool FitCamera(vtkCamera* camera, vtkVolume* volume, double aspect);

  /**
   * Likewise, but a box in the world fits into the picture and fills the share `room` of it, above
   * 0 and at most 1. No data are needed.
   */
  bool FitCameraToBox(vtkCamera* camera, const double bounds[6], double aspect, double room);

protected:
  vtkTetMarchFirstPicture();
  ~vtkTetMarchFirstPicture() override;

private:
  vtkTetMarchFirstPicture(const vtkTetMarchFirstPicture&) = delete;
  void operator=(const vtkTetMarchFirstPicture&) = delete;

  struct Internals;

  bool CheckInput();
  bool CheckChosenArray();
  bool FindCrossings();
  bool UsesStructuredLaw() const;

  std::string ArrayName;
  int ArrayAssociation = ANY;
  int Component = -2;
  double Range[2] = { 1.0, 0.0 };
  int OpacityLaw = OF_THE_DATA;
  bool FitWholeData = false;
  double ChosenRange[2] = { 0.0, 1.0 };
  double Background = 0.0;
  double UnitDistance = 1.0;
  std::unique_ptr<Internals> Found;
};

#endif
