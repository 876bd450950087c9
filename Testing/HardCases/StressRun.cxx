// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
#include "StressRun.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace tetmarch::testing
{
namespace
{
using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr int ChunkRays = 4096;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

json toJson(const StressRow& row)
{
  const RayTotals& t = row.Totals;
  return { { "case", row.Case->Name }, { "group", row.Case->Group },
    { "tetrahedra", row.Tetrahedra }, { "next_chunk", row.NextChunk }, { "seconds", row.Seconds },
    { "rays", t.Rays }, { "met", t.Met }, { "compared", t.Compared }, { "lost", t.Lost },
    { "guarded", t.Guarded }, { "refused", t.Refused }, { "not_finite", t.NotFinite },
    { "negative", t.Negative }, { "out_of_bound", t.OutOfBound },
    { "not_the_answer", t.NotTheAnswer }, { "worst_error", t.WorstError },
    { "worst_generic_error", t.WorstGeneric }, { "first_failure", t.FirstFailure } };
}

void fromJson(const json& from, StressRow& row)
{
  RayTotals& t = row.Totals;
  row.NextChunk = from.at("next_chunk");
  row.Seconds = from.at("seconds");
  t.Rays = from.at("rays");
  t.Met = from.at("met");
  t.Compared = from.at("compared");
  t.Lost = from.at("lost");
  t.Guarded = from.at("guarded");
  t.Refused = from.at("refused");
  t.NotFinite = from.at("not_finite");
  t.Negative = from.at("negative");
  t.OutOfBound = from.at("out_of_bound");
  t.NotTheAnswer = from.at("not_the_answer");
  t.WorstError = from.at("worst_error");
  t.WorstGeneric = from.at("worst_generic_error");
  t.FirstFailure = from.at("first_failure");
}

RayTotals sum(const std::vector<StressRow>& rows)
{
  RayTotals all;
  for (const StressRow& row : rows)
  {
    all += row.Totals;
  }
  return all;
}

class Stress
{
public:
  Stress(const StressOptions& options, const std::function<void(const std::string&)>& tell)
    : Options(options)
    , Tell(tell)
  {
    for (const HardCase& hard : hardCases())
    {
      if (options.Only.empty() || options.Only == hard.Name)
      {
        this->Checks.push_back(std::make_unique<MarchCheck>(hard));
        StressRow row;
        row.Case = &hard;
        row.Tetrahedra = static_cast<std::int64_t>(this->Checks.back()->mesh().Tets.size());
        this->Rows.push_back(row);
      }
    }
    if (this->Rows.empty())
    {
      throw std::runtime_error("there is no hard case named " + options.Only);
    }
    this->resume();
  }

  std::vector<StressRow> run()
  {
    std::vector<std::thread> threads;
    const unsigned count = std::max(std::thread::hardware_concurrency(), 1u);
    for (unsigned i = 0; i < count; ++i)
    {
      threads.emplace_back([this] { this->work(); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    this->save();
    return this->Rows;
  }

private:
  void resume()
  {
    std::ifstream in(this->Options.File);
    if (this->Options.File.empty() || !in)
    {
      return;
    }
    const json saved = json::parse(in);
    if (saved.at("chunk_rays") != ChunkRays)
    {
      throw std::runtime_error(this->Options.File + " is of another version: remove it");
    }
    for (const json& from : saved.at("cases"))
    {
      for (StressRow& row : this->Rows)
      {
        if (row.Case->Name != from.at("case"))
        {
          continue;
        }
        if (row.Tetrahedra != from.at("tetrahedra"))
        {
          throw std::runtime_error(
            this->Options.File + " knows another mesh of " + row.Case->Name + ": remove it");
        }
        fromJson(from, row);
      }
    }
  }

  // Written under another name and renamed, so that there always is a complete file.
  void save() const
  {
    if (this->Options.File.empty())
    {
      return;
    }
    json cases = json::array();
    for (const StressRow& row : this->Rows)
    {
      cases.push_back(toJson(row));
    }
    const std::string part = this->Options.File + ".part";
    std::ofstream(part) << json{ { "chunk_rays", ChunkRays }, { "cases", cases } }.dump(1) << '\n';
    std::filesystem::rename(part, this->Options.File);
  }

  // The case that has had the fewest rays, until all have had their least number; then the case
  // that has taken the least time. Returns nothing when all rays are marched.
  StressRow* choose()
  {
    const auto fewest = std::min_element(this->Rows.begin(), this->Rows.end(),
      [](const StressRow& a, const StressRow& b) { return a.NextChunk < b.NextChunk; });
    const auto cheapest = std::min_element(this->Rows.begin(), this->Rows.end(),
      [](const StressRow& a, const StressRow& b) { return a.Seconds < b.Seconds; });
    const bool lacking = fewest->Totals.Rays < this->Options.LeastRays;
    if ((!lacking && sum(this->Rows).Rays >= this->Options.Rays) ||
        secondsSince(this->Start) > this->Options.Seconds)
    {
      return nullptr;
    }
    return lacking ? &*fewest : &*cheapest;
  }

  void work()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (StressRow* row = this->choose(); row; row = this->choose())
    {
      const MarchCheck& check = *this->Checks[row - this->Rows.data()];
      const unsigned chunk = row->NextChunk++;
      lock.unlock();
      const Clock::time_point start = Clock::now();
      const RayTotals totals = check.run(chunk, ChunkRays);
      const double seconds = secondsSince(start);
      lock.lock();
      row->Seconds += seconds;
      row->Totals += totals;
      this->report();
    }
  }

  void report()
  {
    if (secondsSince(this->Reported) < 10.0)
    {
      return;
    }
    this->Reported = Clock::now();
    const RayTotals all = sum(this->Rows);
    std::ostringstream line;
    line << all.Rays / 1000000 << " million rays, " << all.failures() << " failures, "
         << static_cast<int>(secondsSince(this->Start)) << " s";
    this->Tell(line.str());
    this->save();
  }

  const StressOptions& Options;
  const std::function<void(const std::string&)>& Tell;
  std::vector<std::unique_ptr<MarchCheck>> Checks;
  std::vector<StressRow> Rows;
  std::mutex Mutex;
  const Clock::time_point Start = Clock::now();
  Clock::time_point Reported = Start;
};

void addRow(std::ostream& out, const std::string& group, const std::string& name,
  std::int64_t tetrahedra, const RayTotals& t)
{
  out << "| " << group << " | " << name << " | " << tetrahedra << " | " << t.Rays << " | " << t.Met
      << " | " << t.Compared << " | " << t.Lost << " | " << t.Guarded << " | " << t.Refused << " | "
      << t.NotFinite + t.Negative << " | " << t.OutOfBound << " | " << t.NotTheAnswer << " | "
      << std::setprecision(2) << t.WorstGeneric << " | " << t.WorstError << " |\n";
}
} // namespace

std::vector<StressRow> runStress(
  const StressOptions& options, const std::function<void(const std::string&)>& tell)
{
  return Stress(options, tell).run();
}

std::string stressTable(const std::vector<StressRow>& rows)
{
  std::ostringstream out;
  out << "| group | case | tetrahedra | rays | met the mesh | held against the answer | lost | "
         "guarded | refused | not finite or negative | out of bound | not the answer | worst "
         "length error, generic rays | worst, all rays |\n"
         "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  std::int64_t tetrahedra = 0;
  for (const StressRow& row : rows)
  {
    addRow(out, row.Case->Group, row.Case->Name, row.Tetrahedra, row.Totals);
    tetrahedra += row.Tetrahedra;
  }
  addRow(out, "", "all", tetrahedra, sum(rows));
  return out.str();
}
} // namespace tetmarch::testing
