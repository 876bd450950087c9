// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchVolumeRepresentation
 * @brief   ParaView's volume representation of meshes, drawn by vtkTetMarchVolumeMapper
 *
 * For unstructured, curvilinear and explicit structured grids, blocks of them, beside which there
 * may be surfaces, and adaptive meshes. The mapper receives the input unchanged: cells of all
 * types, with their ids, ghosts and blocks, which it joins. The superclass would decompose cells
 * into tetrahedra, which do not match those of neighbours, merge blocks and remove ghosts, so that
 * ids would differ from those of the input; only its properties set by XML are used. ParaView's
 * lower level of detail during interaction is the same volume, whose mapper casts fewer rays. Cells
 * of the volume can be selected in the view.
 *
 * A view mode adds its legend to the view, in the process that draws.
 */
#ifndef vtkTetMarchVolumeRepresentation_h
#define vtkTetMarchVolumeRepresentation_h

#include "InputProblem.h"                    // For InputProblem
#include "MovedCells.h"                      // For MadeGrid
#include "SelectedBlocks.h"                  // For the selection of blocks
#include "vtkBoundingBox.h"                  // For WholeBounds
#include "vtkTetMarchRepresentationMacros.h" // For methods of both representations
#include "vtkTetMarchRepresentationModule.h" // For export macro
#include "vtkUnstructuredGridVolumeRepresentation.h"

#include <string> // For std::string

class vtkDataObject;
class vtkDummyController;
class vtkMultiProcessController;
class vtkPVRenderView;
class vtkTetMarchLastFrame;
class vtkTetMarchLegend;
class vtkTetMarchVolumeMapper;

class VTKTETMARCHREPRESENTATION_EXPORT vtkTetMarchVolumeRepresentation
  : public vtkUnstructuredGridVolumeRepresentation
{
public:
  static vtkTetMarchVolumeRepresentation* New();
  vtkTypeMacro(vtkTetMarchVolumeRepresentation, vtkUnstructuredGridVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* type, vtkInformation* inInfo, vtkInformation* outInfo) override;

  //@{
  /**
   * The drawn blocks of composite input: see tetmarch::BlockSelection.
   */
  vtkTetMarchBlocksMethodsMacro();
  //@}

  /**
   * The settings of the mapper.
   */
  vtkTetMarchSettings* GetSettings() const;

  //@{
  /**
   * Forwarded to GetSettings(): see vtkTetMarchSettings.
   */
  vtkTetMarchSettingsMethodsMacro();
  //@}

  /**
   * The object by which ParaView gets the statistics of the last frame.
   */
  void SetLastFrame(vtkTetMarchLastFrame* frame);

  //@{
  /**
   * Forwarded to the mapper: see vtkTetMarchVolumeMapper.
   */
  void SetBlendMode(int mode);
  void SetAverageIPScalarRange(double low, double high);
  void SetCropping(bool cropping);
  void SetCroppingRegionFlags(int flags);
  //@}

  //@{
  /**
   * Cropping planes, with the names of vtkImageVolumeRepresentation: for each axis, the bounds of
   * the data of all processes, times the scale, plus the origin, in the coordinates of the data.
   * With the defaults, 1 and 0, nothing is cropped.
   */
  vtkSetVector3Macro(CroppingOrigin, double);
  vtkGetVector3Macro(CroppingOrigin, double);
  vtkSetVector3Macro(CroppingScale, double);
  vtkGetVector3Macro(CroppingScale, double);
  //@}

  //@{
  /**
   * In parallel, the visits of rays to the pieces of all processes are composited in order of
   * depth, pixel by pixel (vtkTetMarchVolumeMapper::SetController()). On by default. If it is off,
   * on tile displays, and if the view composites translucent geometry in order, pieces are drawn
   * over each other. With UseDataPartitions these are the original pieces, in the order of their
   * boxes. Without it the view redistributes cells by a k-d tree; a cell in several of its regions
   * is moved to all of them, and each process ends its rays at the planes of its region.
   */
  vtkSetMacro(ExactCompositing, bool);
  vtkGetMacro(ExactCompositing, bool);
  //@}

  //@{
  /**
   * @sa vtkVolumeProperty
   */
  void SetShade(bool shade);
  void SetAmbient(double ambient);
  void SetDiffuse(double diffuse);
  void SetSpecular(double specular);
  void SetSpecularPower(double power);
  void SetNumberOfIsosurfaces(int number);
  void SetIsosurfaceValue(int i, double value);
  //@}

  /**
   * The legend is visible only with the volume.
   */
  void SetVisibility(bool visible) override;

protected:
  vtkTetMarchVolumeRepresentation();
  ~vtkTetMarchVolumeRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void UpdateMapperParameters() override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkTetMarchVolumeRepresentation(const vtkTetMarchVolumeRepresentation&) = delete;
  void operator=(const vtkTetMarchVolumeRepresentation&) = delete;

  struct PieceReport
  {
    bool Drawable = true;
    std::string Message; // empty if nothing is wrong
  };

  void AgreeOnMoves(bool hasInput);
  bool MovesCells() const;
  void OfferData(vtkInformation* inInfo, vtkInformation* outInfo);
  void PrepareToRender(vtkInformation* inInfo);
  bool DrawsPieces(vtkPVRenderView* view) const;
  vtkMultiProcessController* FindPartners(vtkInformation* inInfo, vtkPVRenderView* view);
  vtkDataObject* TakeArrived(vtkDataObject* delivered, vtkPVRenderView* view);
  PieceReport CheckPieces(vtkPVRenderView* view) const;
  void ReportOnce(const std::string& message);

  vtkSmartPointer<vtkDataObject> Drawn; // of this process
  std::string WhyNotMoved;              // the same in all processes; empty if cells can be moved
  tetmarch::MadeGrid Packed{ tetmarch::packCells };    // of Drawn
  tetmarch::MadeGrid Arrived{ tetmarch::unpackCells }; // of what was delivered
  std::string LastReport;
  vtkNew<vtkDummyController> Alone;
  vtkBoundingBox WholeBounds; // of that of all processes
  tetmarch::BlockSelection Blocks;
  tetmarch::InputProblem InputProblem;
  bool ExactCompositing = true;
  double CroppingOrigin[3] = { 0, 0, 0 };
  double CroppingScale[3] = { 1, 1, 1 };
  vtkNew<vtkTetMarchVolumeMapper> TetMarchMapper;
  vtkNew<vtkTetMarchLegend> Legend;
};

#endif
