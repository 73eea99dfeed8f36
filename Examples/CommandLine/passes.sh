# SPDX-FileCopyrightText: Copyright (c) the Lambent authors
# SPDX-License-Identifier: BSD-3-Clause
lambent Data/seashell.vtp -o seashell.png --size 480x270 --alpha \
  --pass depth=depth.tif --pass ids=cells.tif --pass normals=normals.vti

lambent Data/seashell.vtp -o seashell.vti --size 480x270 --pass depth --pass positions
