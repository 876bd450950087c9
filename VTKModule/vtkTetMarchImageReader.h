// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTetMarchImageReader
 * @brief   Reads images from files of NRRD (.nrrd, .nhdr) and MetaImage (.mha, .mhd)
 *
 * Unlike vtkNrrdReader and vtkMetaImageReader it keeps the directions of axes, reads values that
 * are text, and checks what a header says against the length of the files before it takes memory
 * by that. A file that contradicts itself is one error that says what is wrong.
 *
 * Values keep their type. A NRRD axis that is not of space (by `space directions` or `kinds`; the
 * first of four if there are neither) is that of components, which must be together. Images of up
 * to three axes are read. Of NRRD all encodings are read but bzip2. Data in files of their own may
 * be one file, a list, or numbered by a pattern.
 */
#ifndef vtkTetMarchImageReader_h
#define vtkTetMarchImageReader_h

#include "vtkImageAlgorithm.h"
#include "vtkRenderingTetMarchModule.h" // For export macro

#include <memory> // For the header

class VTKRENDERINGTETMARCH_EXPORT vtkTetMarchImageReader : public vtkImageAlgorithm
{
public:
  static vtkTetMarchImageReader* New();
  vtkTypeMacro(vtkTetMarchImageReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * The file with the header, by the ending of whose name its format is known.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  //@}

protected:
  vtkTetMarchImageReader();
  ~vtkTetMarchImageReader() override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkTetMarchImageReader(const vtkTetMarchImageReader&) = delete;
  void operator=(const vtkTetMarchImageReader&) = delete;

  void Refuse(const std::string& reason);

  char* FileName = nullptr;
  struct Found;
  std::unique_ptr<Found> Header;
};

#endif
