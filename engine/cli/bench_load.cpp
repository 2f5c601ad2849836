#include "engine/cli/bench.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/validate.hpp"

namespace windloom::cli {

Result<std::vector<BenchRow>> benchLoad(const BenchSetup& setup) {
  const int arrows = setup.size == BenchSize::Quick ? 100 : 10'000;
  const Project project = benchProject(1000, arrows);
  const std::string text = writeProject(project);
  if (Result<LoadedProject> parsed = parseProject(text, "benchmark"); !parsed) return parsed.error();
  std::vector<BenchRow> rows;
  const auto add = [&](const char* what, const std::function<void()>& work) {
    const Measured m = measure({1, 3, 20, setup.capSeconds}, [&] { return wallMs(work); });
    rows.push_back({{"what", what}, {"arrows", arrows}, {"ms", m.median}, {"runs", m.runs}});
  };
  std::size_t kept = 0;  // what the work gives is used, so that none is optimised away
  add("read the file's text, with validation",
      [&] { kept += parseProject(text, "benchmark")->project.graph->arrows.size(); });
  add("validate", [&] { kept += validate(project).size(); });
  add("make the graph ready", [&] { kept += GraphEvaluator(*project.graph).arrivals().size(); });
  const GraphEvaluator graph(*project.graph);
  add("evaluate the graph at a moment", [&] { kept += graph.forcesAt(1.0).size(); });
  add("write the file's text", [&] { kept += writeProject(project).size(); });
  rows.back()["MB"] = static_cast<double>(text.size()) / 1e6;
  WL_REQUIRE(kept > 0, "a project with arrows has arrows");
  return rows;
}

}  // namespace windloom::cli
