// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchWebExporter
 * @brief   Write a scene with volumes as one web page
 *
 * The page draws the volumes of a renderer that have a vtkTetMarchVolumeMapper or a
 * vtkTetMarchSmartVolumeMapper with the same shaders as these mappers, in any browser with WebGL 2,
 * and the opaque surfaces among them as triangles. It is one file that loads nothing else: it opens
 * by a double click. Camera, transfer functions and accuracy can be changed in the page; blend
 * mode, light and cuts are those of the scene.
 *
 * The renderer is the ActiveRenderer, or the first one of the window. The window is rendered while
 * the scene is captured, so it must have a context of OpenGL; its picture stays as it was. What the
 * page cannot show is listed by GetOmissions() and, unless it is empty, in the page.
 *
 * @sa vtkExporter
 */
#ifndef vtkTetMarchWebExporter_h
#define vtkTetMarchWebExporter_h

#include "vtkExporter.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchWebExporter : public vtkExporter
{
public:
  static vtkTetMarchWebExporter* New();
  vtkTypeMacro(vtkTetMarchWebExporter, vtkExporter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The path of the page; nullptr by default. Without one, Write() is an error and WriteToString()
   * is not.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

  //@{
  /**
   * The title of the page, as text; nullptr (the default) is the name of the first volume's array.
   */
  vtkSetStringMacro(Title);
  vtkGetStringMacro(Title);
  //@}

  //@{
  /**
   * Whether the page has a panel with transfer functions, accuracy and so on, or the picture alone,
   * which still follows mouse, touch and keys; on by default.
   */
  vtkSetMacro(Controls, bool);
  vtkGetMacro(Controls, bool);
  vtkBooleanMacro(Controls, bool);
  //@}

  /**
   * Capture the scene as it is now, as a step in time with this label. Arrays that are equal in
   * several steps are in the page once. Write() captures the scene itself if no step was added.
   * Returns whether it worked; if not, an error was reported.
   */
  bool AddTimeStep(const char* label);
  /** Forget all steps that were added. */
  void ClearTimeSteps();

  /** The page as text. Empty if it failed; then an error was reported. */
  std::string WriteToString();

  /**
   * What of the captured steps, or of the last page, is not in the page: a sentence per line. Empty
   * if everything is.
   */
  std::string GetOmissions() const;

protected:
  vtkTetMarchWebExporter();
  ~vtkTetMarchWebExporter() override;

  void WriteData() override;

private:
  vtkTetMarchWebExporter(const vtkTetMarchWebExporter&) = delete;
  void operator=(const vtkTetMarchWebExporter&) = delete;

  class Internals;

  bool WritePage(ostream& stream);

  char* FileName = nullptr;
  char* Title = nullptr;
  bool Controls = true;
  const std::unique_ptr<Internals> Internal;
};

#endif
