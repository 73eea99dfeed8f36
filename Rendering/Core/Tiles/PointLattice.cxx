// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointLattice.h"

namespace lambent
{
namespace
{
// The largest number of groups of samples: 2k + 1 stays below "not finite".
constexpr int maximumGroups = 32000;

// Positions are computed from values of up to |origin| + count samples, with a few roundings of
// 2^-53 each.
double marginOf(double origin, int count)
{
  return std::ldexp(std::fabs(origin) + count, -44) + std::ldexp(1.0, -30);
}
}

PointLattice::PointLattice(const CameraFrame& frame, const Window& window)
  : Frame(frame)
  , SamplesPerUnit(1.0 / frame.pixel)
  , Columns{ frame.centerX - 0.5 - window.i0, marginOf(frame.centerX, window.i1), window.width() }
  , Rows{ frame.centerY - 0.5 - window.j0, marginOf(frame.centerY, window.j1), window.height() }
{
  while ((std::max(this->Columns.count, this->Rows.count) >> this->Shift) >= maximumGroups)
  {
    ++this->Shift;
  }
}

std::uint16_t PointLattice::position(const Axis& axis, double u, int shift)
{
  if (std::isnan(u))
  {
    return LatticePosition::anywhere;
  }
  const double last = axis.count;
  const double left = std::min(std::max(u - axis.margin, 0.0), last);
  const double right = std::min(std::max(u + axis.margin + 1.0, 0.0), last);
  const int truncated = static_cast<int>(left);
  const int first = truncated + (truncated < left); // rounded up
  const int end = static_cast<int>(right);          // rounded down
  const int firstGroup = first >> shift;
  const int endGroup = (end + (1 << shift) - 1) >> shift;
  return static_cast<std::uint16_t>(firstGroup + endGroup); // 2k, or 2k + 1
}

LatticePosition PointLattice::locate(const Vec3& point) const
{
  const FramePoint p = this->Frame.toFrame(point);
  if (!(p.w > 0.0) || !std::isfinite(p.z) || !this->isPrecise())
  {
    // Each axis of the frame combines all coordinates, so one that is not finite shows in z.
    const std::uint16_t nowhere =
      isFinite(point) ? LatticePosition::anywhere : LatticePosition::notFinite;
    return { nowhere, nowhere };
  }
  const double perUnit = this->SamplesPerUnit / p.w;
  const double u = p.x * perUnit + this->Columns.origin;
  const double v = p.y * perUnit + this->Rows.origin;
  const LatticePosition result{ position(this->Columns, u, this->Shift),
    position(this->Rows, v, this->Shift) };
  if (result.column == LatticePosition::anywhere || result.row == LatticePosition::anywhere)
  {
    return { LatticePosition::anywhere, LatticePosition::anywhere };
  }
  return result;
}
}
