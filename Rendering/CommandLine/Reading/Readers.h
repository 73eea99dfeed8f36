// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the functions in the table of formats
 *
 * Each takes a file that exists and is not empty (ReadFoam also takes an empty one), and throws
 * Failure if it cannot be read completely.
 */

#ifndef Readers_h
#define Readers_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;

namespace lambent::command
{

class Progress;
class VtkMessages;

// In ReadMeshFiles.cxx: polygon meshes and grids, with checks.
vtkSmartPointer<vtkDataObject> ReadVtpFile(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadVtuFile(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadLegacyVtkFile(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadPlyFile(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadStlFile(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadObjFile(const std::string&, VtkMessages&, Progress&);

// In ReadVtkGrids.cxx: structured data in VTK's XML formats, in one file or in pieces.
vtkSmartPointer<vtkDataObject> ReadVti(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadVtr(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadVts(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadPvti(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadPvtr(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadPvts(const std::string&, VtkMessages&, Progress&);

// In ReadCollection.cxx: files that name other files.
vtkSmartPointer<vtkDataObject> ReadPieces(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadBlocks(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadPvd(const std::string&, VtkMessages&, Progress&);

// In ReadOff.cxx, ReadGifti.cxx, ReadGmsh.cxx, ReadAbaqus.cxx, ReadGltf.cxx, ReadSimulation.cxx
// and ReadAssimp.cxx.
vtkSmartPointer<vtkDataObject> ReadOff(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadGifti(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadGmsh(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadAbaqus(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadGltf(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadFoam(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadExodus(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadEnSight(const std::string&, VtkMessages&, Progress&);
vtkSmartPointer<vtkDataObject> ReadAssimp(const std::string&, VtkMessages&, Progress&);

} // namespace lambent::command

#endif
