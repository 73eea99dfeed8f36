// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render.h"

#include "GatheredPoints.h"
#include "Pace.h"
#include "TileTasks.h"

namespace lambent
{
namespace
{
/// The approximate shares of the work that the first two of the three passes do.
constexpr double pointsShare = 0.1;
constexpr double binningShare = 0.3;

/// The largest number of points or primitives processed between two progress reports.
constexpr std::size_t mostItems = 1024 * 1024;

/// Tiles hold whole pixels. With several samples per pixel, larger tiles are faster, unless there
/// are two or three and the primitives are small.
int tileSize(const Settings& settings, const Image& image, std::size_t primitives)
{
  const int n = image.samples;
  const std::size_t samples = static_cast<std::size_t>(image.width) * image.height * n * n;
  const bool isLarge = n >= 4 || (n > 1 && samples / 256 > primitives);
  const int size = 1 << (settings.tileShift + (isLarge ? 1 : 0));
  return std::max(1, size / n) * n;
}

class Picture
{
public:
  Picture(const Scene& scene, const Image& image, const Parallel& parallel,
    const Progress& progress, const Settings& settings)
    : Workers(parallel)
    , Tell(progress)
    , How(settings)
    , Mesh(scene.surfaces, parallel)
    , Samples(image.samplePart())
    , Frame(scene.camera, image.width * image.samples, image.height * image.samples, image.samples)
    , Lattice(this->Frame, this->Samples)
    , Positions(new LatticePosition[this->Mesh.pointCount()])
    , Grid(this->Samples.width(), this->Samples.height(),
        tileSize(settings, image, this->Mesh.primitiveCount()))
    , InFrame(this->Mesh, this->Frame)
    , Binner(this->InFrame, this->Lattice, this->Positions.get(), this->Grid, this->Samples,
        settings.culling, settings.kernels)
    , BinningPace(
        std::max<std::size_t>(mostItems / (image.samples * image.samples), 4096), mostItems)
    , Caster(this->InFrame, this->Grid)
    , LayerCaster(this->InFrame, this->Grid)
    , Points(this->InFrame, scene.twoSidedLighting)
    , Light(scene, this->Frame.eye)
    , Target(scene, image)
    , Passes(this->Points, this->Target.target())
    , Painter(this->Points, this->Light, this->Target, this->Passes)
    , LayerPainter(this->Points, this->Light, this->Target, this->Passes)
    , Work(this->Frame, this->Samples, this->Grid,
        { this->InFrame, this->Caster, this->LayerCaster, this->Painter, this->LayerPainter },
        parallel.workers(), settings.kernels)
  {
    for (int worker = 0; worker < parallel.workers(); ++worker)
    {
      this->Filled.push_back(std::make_unique<BinningMemory>(this->Grid, parallel.workers()));
      this->FilledBins.push_back(&this->Filled.back()->result.bins);
    }
  }

  Report make()
  {
    Report report;
    bool goesOn = this->locatePoints();
    for (std::size_t next = 0; goesOn && !this->IsComplete;)
    {
      goesOn = this->binPrimitives(next);
      report.defects = this->defects();
      if (report.defects.wrongCorner != noPrimitive)
      {
        report.outcome = Outcome::BadMesh;
        return report;
      }
      goesOn = goesOn && this->processTiles(next);
    }
    report.outcome = goesOn ? Outcome::Done : Outcome::Aborted;
    return report;
  }

private:
  bool goOn(double done) const { return !this->Tell || this->Tell(done); }

  /// Calls body(worker, begin, end) for chunks of [begin, end).
  template <typename Body>
  void forChunks(std::size_t begin, std::size_t end, Body&& body) const
  {
    const std::size_t chunk = this->How.chunk;
    forEach(this->Workers, 0, (end - begin + chunk - 1) / chunk,
      [&](int worker, std::size_t i)
      { body(worker, begin + i * chunk, std::min(end, begin + (i + 1) * chunk)); });
  }

  bool locatePoints()
  {
    const std::size_t count = this->Mesh.pointCount();
    Pace pace(mostItems, mostItems);
    for (std::size_t begin = 0, end = 0; begin < count; begin = end)
    {
      const PartClock clock;
      end = std::min(count, begin + pace.items());
      this->forChunks(
        begin, end, [this](int, std::size_t from, std::size_t to) { this->locate(from, to); });
      pace.adjust(clock.elapsed());
      if (!this->goOn(pointsShare * end / count))
      {
        return false;
      }
    }
    return true;
  }

  void locate(std::size_t begin, std::size_t end)
  {
    GatheredPoints gathered(this->Lattice);
    this->Mesh.forPoints(begin, end,
      [&](const SceneMesh::Part& part, std::size_t from, std::size_t to)
      {
        if (part.kind() != PrimitiveKind::Triangle)
        {
          return; // the binning of other kinds locates them
        }
        LatticePosition* const positions = this->Positions.get() + part.firstPoint;
        if (this->How.kernels)
        {
          gathered.locate(part.points(), from, to, positions);
          return;
        }
        for (std::size_t p = from; p < to; ++p)
        {
          positions[p] = this->Lattice.locate(part.surface->points[p]);
        }
      });
    gathered.flush();
  }

  /// Bins primitives from next on until none are left or the bins are full. Then next is the first
  /// primitive that is left.
  bool binPrimitives(std::size_t& next)
  {
    const std::size_t count = this->Mesh.primitiveCount();
    std::size_t pages = 0;
    for (const auto& memory : this->Filled)
    {
      memory->result.bins.clear();
    }
    while (next < count && pages < this->How.binPages)
    {
      const PartClock clock;
      const std::size_t end = std::min(count, next + this->BinningPace.items());
      this->forChunks(next, end,
        [this](int worker, std::size_t from, std::size_t to)
        { this->Binner.run(from, to, *this->Filled[worker]); });
      next = end;
      pages = 0;
      forEach(this->Workers, 0, this->Filled.size(),
        [this](int, std::size_t k) { this->Binner.flush(*this->Filled[k]); });
      for (const auto& memory : this->Filled)
      {
        pages += memory->result.bins.pageCount();
      }
      this->BinningPace.adjust(clock.elapsed());
      if (!this->goOn(pointsShare + binningShare * next / count))
      {
        return false;
      }
    }
    return true;
  }

  /// The primitives from next on are left for further rounds.
  bool processTiles(std::size_t next)
  {
    const std::size_t count = this->Mesh.primitiveCount();
    const bool isLastRound = next == count;
    this->Work.plan(this->FilledBins);
    const std::size_t batches = this->Work.batchCount();
    for (std::size_t batch = 0; batch < batches; ++batch)
    {
      this->Work.run(batch, this->FilledBins, this->Workers, isLastRound);
      const double before =
        pointsShare + (isLastRound ? binningShare : binningShare * next / count);
      const double share = isLastRound ? 1.0 - before : 0.0;
      if (!this->goOn(before + share * (batch + 1) / batches))
      {
        return false;
      }
    }
    this->IsComplete = isLastRound;
    return true;
  }

  MeshDefects defects() const
  {
    MeshDefects all;
    for (const auto& memory : this->Filled)
    {
      all.merge(memory->result.defects);
    }
    return all;
  }

  const Parallel& Workers;
  const Progress& Tell;
  const Settings How;
  const SceneMesh Mesh;
  const Window Samples; ///< the image's part, in samples
  const CameraFrame Frame;
  const PointLattice Lattice;
  const std::unique_ptr<LatticePosition[]> Positions;
  const TileGrid Grid;
  const FrameMesh InFrame;
  const Binning Binner;
  Pace BinningPace;
  std::vector<std::unique_ptr<BinningMemory>> Filled; ///< one per worker
  std::vector<const Bins*> FilledBins;
  const Casting<Nearest> Caster;
  const Casting<Layers> LayerCaster;
  const SurfacePoints Points;
  const LightModel Light;
  const Film Target;
  const PassPainting Passes;
  const Painting Painter;
  const LayerPainting LayerPainter;
  TileTasks Work;
  bool IsComplete = false;
};
}

Report render(const Scene& scene, const Image& image, const Parallel& parallel,
  const Progress& progress, const Settings& settings)
{
  const Window& part = image.part;
  if (part.empty())
  {
    return Report();
  }
  const std::size_t samplesPerRow =
    static_cast<std::size_t>(part.width()) * image.samples * image.samples;
  const int rows = image.samples == 1
    ? part.height()
    : static_cast<int>(std::clamp<std::size_t>(
        settings.mostSamples / samplesPerRow, 1, static_cast<std::size_t>(part.height())));
  Report report;
  for (int j0 = part.j0, j1 = 0; j0 < part.j1 && report.outcome == Outcome::Done; j0 = j1)
  {
    j1 = std::min(part.j1, j0 + rows);
    const auto ofAll = [&, j0](double done)
    { return progress((j0 - part.j0 + done * (j1 - j0)) / part.height()); };
    report =
      Picture(scene, image.rows(j0, j1), parallel, progress ? Progress(ofAll) : nullptr, settings)
        .make();
  }
  return report;
}
}
