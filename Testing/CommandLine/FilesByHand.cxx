// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "BrokenFiles.h"

std::vector<File> MakeFilesByHand()
{
  std::vector<File> files;
  files.push_back({ "all kinds of lines ", ".obj",
    "mtllib m.mtl\no box\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0\nv 0 1 .5 0 0 1\nvt 0 0\nvt 1 "
    "0.25\n"
    "vn 0 0 1\nvn 0 0.6 .8\ng front\nusemtl a\ns 1\nf 1/1/1 2/2/-1 3/2/1\ns off\nf 1//2 \\\n3 4/2\n"
    "l 1 2/1 3\np 1 -2\ns 2\nf -4 -3 -2 -1 # all\n" });
  files.push_back({ "smoothing groups ", ".obj",
    "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 .5\r\nvt 0 1\r\nvt 1 1\r\ns 1\r\nf 1/1 2/2 3/1\r\n"
    "s 2\r\nf 1/2 3/2 4/2\r\n" });
  files.push_back({ "capitals ", ".stl",
    "SOLID W\xfcrfel\n FACET NORMAL 0 0 1\n  OUTER LOOP\n   VERTEX 0 0 0\n   VERTEX 1 0 0\n"
    "   VERTEX 0 1 0\n  ENDLOOP\n ENDFACET\nENDSOLID\n" });
  const std::string strips = "element vertex 4\nproperty char x\nproperty char y\nproperty char z\n"
                             "element tristrips 1\nproperty list char char vertex_indices\n"
                             "end_header\n";
  const std::string bytes(
    "\x00\x00\x00\x01\x00\x00\x00\x01\x00\x01\x01\x00\x08\x00\x01\x02\x03\xff\x00\x01\x03", 21);
  files.push_back({ "strips ", ".ply", "ply\nformat binary_little_endian 1.0\n" + strips + bytes });
  files.push_back({ "strips in text ", ".ply",
    "ply\nformat ascii 1.0\n" + strips + "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 0 1 3 -1\n" });
  return files;
}
