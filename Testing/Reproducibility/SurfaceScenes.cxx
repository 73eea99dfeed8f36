// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with all kinds of cells, arrays, normals and materials.
#include "Scenes.h"

using lambent::Weighting;

namespace
{
/// Two boxes without common points, as one body with sharp edges for normals to smooth.
Body& boxes(Stage& s)
{
  s.daylight();
  return s.add(joined(box({ 0.5, 1.0, 0.75 }), moved(box({ 0.25, 0.5, 0.5 }), { 1.0, 0.25, 0.5 })));
}

void weighted(Stage& s, Weighting how)
{
  boxes(s).weigh(how);
  s.add(moved(hills(12), { 0.0, 0.0, -1.0 })).weigh(how);
}
}

SceneList surfaceScenes()
{
  return {
    { "surface-flat",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(2)).flat();
      } },
    { "surface-unlit", [](Stage& s) { s.add(ball(2)).unlit(); } },
    { "surface-own-normals",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(2)).round();
      } },
    { "surface-normals-by-angle", [](Stage& s) { weighted(s, Weighting::Angle); } },
    { "surface-normals-by-area", [](Stage& s) { weighted(s, Weighting::Area); } },
    { "surface-normals-alike", [](Stage& s) { weighted(s, Weighting::Uniform); } },
    { "surface-normals-after-max", [](Stage& s) { weighted(s, Weighting::Max); } },
    { "surface-normals-of-any-length",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(3)).round();
        RandomNumbers random(7);
        for (Vec3& n : body.pointNormals)
        {
          const double factors[] = { 1e-9, 1.0, 1e9, 0.0 };
          n = n * factors[random.below(4)];
        }
      } },
    { "surface-normals-of-chance",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(3)).round();
        RandomNumbers random(8);
        for (Vec3& n : body.pointNormals)
        {
          n = random.inBox(1.0);
        }
      } },
    { "surface-cell-normals",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(2)).flat();
        RandomNumbers random(9);
        for (const auto& cell : body.shape.cells)
        {
          body.cellNormals.push_back(body.shape.points[cell[0]] + random.inBox(0.25));
        }
      } },
    { "surface-sharp-edges",
      [](Stage& s)
      {
        s.daylight();
        s.add(moved(box(Vec3(0.6)), Vec3(-0.7, -0.3, 0.0)));
        s.add(moved(scaled(cylinder(3), Vec3(0.5)), Vec3(0.8, 0.4, 0.0)));
        s.add(moved(scaled(star(7), Vec3(0.4)), Vec3(0.6, -0.6, 0.8)));
      } },
    { "surface-faces-there-twice",
      [](Stage& s)
      {
        s.daylight();
        s.hasTies = true;
        Shape sheet = hills(12);
        const Shape other = turned(sheet);
        sheet.cells.insert(sheet.cells.end(), other.cells.begin(), other.cells.end());
        s.add(sheet).floats();
      } },
    { "surface-faces-this-way-and-that",
      [](Stage& s)
      {
        s.daylight();
        Shape mixed = hills(12);
        const Shape other = turned(mixed);
        for (std::size_t k = 0; k < mixed.cells.size(); k += 3)
        {
          mixed.cells[k] = other.cells[k];
        }
        s.add(mixed);
      } },
    { "surface-mirrored",
      [](Stage& s)
      {
        s.daylight();
        s.add(scaled(ball(3), Vec3(-0.9, 0.7, 0.8))).round();
        Body& body =
          s.add(moved(scaled(ball(1), Vec3(0.4, -0.4, 0.4)), Vec3(0.0, 1.0, 0.5))).flat();
        for (const auto& cell : body.shape.cells)
        {
          body.cellNormals.push_back(body.shape.points[cell[0]] - Vec3(0.0, 1.0, 0.5));
        }
      } },
    { "surface-fronts-culled",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(3)).round().appearance.cullFront = true;
      } },
    { "surface-backs-culled",
      [](Stage& s)
      {
        s.daylight();
        s.add(cylinder(5)).flat().appearance.cullBack = true;
        s.look({ 1.0, 3.0, 2.5 }, Vec3(0.0));
      } },
    { "surface-quads", [](Stage& s) { boxes(s).flat(); } },
    { "surface-cylinder",
      [](Stage& s)
      {
        s.daylight();
        s.add(cylinder(6));
        s.look({ 2.0, 3.0, 2.5 }, Vec3(0.0));
      } },
    { "surface-concave-polygon",
      [](Stage& s)
      {
        s.daylight();
        s.add(star(4)).flat();
      } },
    { "surface-concave-polygon-smooth",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(star(5));
        RandomNumbers random(10);
        for (Vec3& p : body.shape.points)
        {
          p = p + random.inBox(0.0625); // not quite planar
        }
      } },
    { "surface-strips",
      [](Stage& s)
      {
        s.daylight();
        s.add(ribbons(9)).strips().flat();
      } },
    { "surface-strips-smooth",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ribbons(17)).strips();
        for (Vec3& p : body.shape.points)
        {
          p.z = (p.x * p.y) * (1.0 - p.x * p.x);
        }
      } },
    { "surface-floats-and-32-bit-ids",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(3)).floats();
        s.add(moved(box({ 0.3, 0.7, 0.2 }), { 1.1, 0.1, 0.7 })).floats().flat();
      } },
    { "surface-several-inputs",
      [](Stage& s)
      {
        s.daylight();
        for (int k = 0; k < 6; ++k)
        {
          Body& body =
            s.add(moved(scaled(ball(2), Vec3(0.5)), { 0.4 * k - 1.0, 0.1 * k, -0.3 * k }));
          body.paint({ 0.15 * k, 1.0 - 0.15 * k, 0.5 }, Vec3(0.02 * k));
          k % 3 == 1 ? body.flat() : k % 3 == 2 ? body.unlit() : body;
        }
      } },
    { "surface-through-each-other",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(3)).round();
        s.add(moved(ball(3), { 0.7, 0.3, 0.2 })).paint({ 0.2, 0.9, 0.4 }).flat();
        s.add(hills(20)).paint({ 0.9, 0.2, 0.1 });
      } },
  };
}
