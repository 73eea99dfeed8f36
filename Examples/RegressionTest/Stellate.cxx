// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief stellate INPUT.vtp OUTPUT.vtp HEIGHT
 */

#include "vtkStellate.h"

#include "vtkNew.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkStellate> stellate;
  stellate->SetInputConnection(reader->GetOutputPort());
  stellate->SetHeight(std::atof(argv[3]));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(stellate->GetOutputPort());
  writer->SetFileName(argv[2]);
  return writer->Write() ? EXIT_SUCCESS : EXIT_FAILURE;
}
