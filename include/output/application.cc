/* ---------------------------------------------------------------------
 * Copyright (C) 2026 by the authors of the contact program
 * SPDX-License-Identifier: LGPL-2.1-or-later
 * --------------------------------------------------------------------- */

#include "output/application.h"

#include <deal.II/base/mpi.h>

#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <iostream>
#include <set>

#include "base/all_ranks.h"
#include "base/command_line.h"
#include "base/errors.h"
#include "base/files.h"
#include "base/interruption.h"
#include "base/string_utilities.h"
#include "mesh/automatic_pairs.h"
#include "mesh/cad_file.h"
#include "output/effect_runs.h"
#include "output/result_files.h"
#include "output/result_tables.h"

namespace Contact
{
  namespace
  {
    // The run by which errors are estimated leaves no files but its summary.
    Parameters::All refined_case(const Parameters::All &coarse)
    {
      Parameters::All finer = coarse;
      finer.name += "_refined";
      finer.mesh.refinements += 1;
      finer.output.vtu = finer.output.profile = false;
      return finer;
    }



    bool asks_for_refined(const Parameters::All &parameters)
    {
      return parameters.probes.errors == Parameters::Errors::next_mesh &&
             !parameters.has_levels();
    }



    const std::string first_attempt = "first_attempt"; // a directory



    // The results of an attempt that has ended on its way stay beside those of
    // the next one, which may get less far.
    void set_aside(const std::filesystem::path &directory,
                   const bool                   has_results)
    {
      const auto aside = directory / first_attempt;
      std::filesystem::remove_all(aside);
      if (!has_results)
        return;
      std::filesystem::create_directory(aside);
      for (const auto &file : std::filesystem::directory_iterator(directory))
        if (file.is_regular_file() &&
            is_result_file(file.path().filename().string()))
          std::filesystem::rename(file.path(), aside / file.path().filename());
    }



    // The last solution of a run, as far as it got.
    double reached(const RunSummary &summary)
    {
      double t = 0;
      for (const IncrementRecord &record : summary.increments)
        if (record.converged)
          t = record.load_factor;
      return t;
    }



    // A case that does not converge by the loops that it asks for is solved
    // once more, from the start, by others. If none converges, the result is
    // that of the last ones.
    RunSummary solve_robustly(const Parameters::All  &parameters,
                              const ParameterHandler &prm,
                              const SolveCase        &solve)
    {
      const bool is_first_rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      RunSummary      summary = solve(parameters, prm);
      Parameters::All same    = parameters;
      same.in_space           = summary.in_space;
      same.is_repeated        = true;
      double of_first         = 0; // the load factor that it got to
      for (Parameters::All &other :
           same.with_other_loops(summary.n_displacements))
        {
          if (summary.converged || summary.interrupted)
            break;
          const std::string loops =
            "Friction = " + other.solution.friction.name() +
            ", Geometry = " + other.solution.geometry.name() +
            ", System = " + other.solution.system.name() +
            (other.has_levels() == parameters.has_levels()
               ? ""
               : ", Levels = 0, Refinements = " +
                   std::to_string(other.mesh.refinements));
          if (is_first_rank)
            std::cerr << parameters.name << ": " << summary.message
                      << "\nOnce more from the start, with " << loops
                      << std::endl;
          if (of_first == 0)
            {
              of_first = reached(summary);
              if (is_first_rank)
                set_aside(parameters.directory(), of_first > 0);
            }
          other.findings.push_back(
            {"not solved by the loops and the system that the case asks for (" +
               summary.message + "), this is an attempt with " + loops +
               (of_first > 0 ? "; results up to t = " + brief(of_first) +
                                 " of one before are in " + first_attempt
                             : ""),
             /*is_violated=*/false,
             parameters.name});
          summary = solve(other, prm);
        }
      if (is_first_rank && summary.converged)
        std::filesystem::remove_all(parameters.directory() / first_attempt);
      return summary;
    }



    // With what runs beside the first one have found.
    void rewrite_summary(const Parameters::All &parameters,
                         const RunSummary      &summary)
    {
      write_on_first_rank(MPI_COMM_WORLD,
                          parameters.directory() / "summary.json",
                          [&](std::ostream &out) {
                            write_summary(summary, out);
                          });
    }



    // The parameters in the directory of the refined case would be those of the
    // first.
    RunSummary run_case(const Parameters::All  &parameters,
                        const ParameterHandler &prm,
                        const SolveCase        &solve)
    {
      RunSummary summary = solve_robustly(parameters, prm, solve);
      if (!summary.converged)
        return summary;
      if (parameters.solution.estimate_effects && summary.in_space)
        {
          Parameters::All scene = parameters;
          scene.in_space        = true;
          estimate_effects_by_runs(scene, prm, solve, summary);
          rewrite_summary(parameters, summary);
        }
      if (!asks_for_refined(parameters))
        return summary;
      const Parameters::All refined = refined_case(parameters);
      const RunSummary      other   = solve_robustly(refined, prm, solve);
      if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          std::error_code error;
          std::filesystem::remove(refined.directory() / "parameters.prm",
                                  error);
        }
      summary.interrupted = other.interrupted;
      if (other.converged)
        estimate_errors(summary, other.probes);
      else if (!other.interrupted)
        tell({"no error estimate, because the case '" + refined.name +
                "' does not converge: " + other.message,
              /*is_violated=*/false,
              parameters.name},
             summary.findings);
      rewrite_summary(parameters, summary);
      return summary;
    }



    // A process that no launcher has started as one of several talks to nobody:
    // without Open MPI's daemon and network it starts in half the time. What
    // the environment says comes first. It needs no directory for its session,
    // either: all such processes would share one, and remove it from under each
    // other. Processes that are all on one machine talk by its memory: to look
    // for a network would take them 0.2 s.
    void spare_network()
    {
      const auto value = [](const char *variable) {
        const char *const found = std::getenv(variable);
        return std::string(found == nullptr ? "" : found);
      };
      const std::string all = value("OMPI_COMM_WORLD_SIZE");
      const bool        is_launched =
        !(all + value("PMIX_RANK") + value("PMI_RANK")).empty();
      if (is_launched &&
          (all.empty() || all != value("OMPI_COMM_WORLD_LOCAL_SIZE")))
        return;
      setenv("OMPI_MCA_pml", "ob1", /*overwrite=*/0);
      setenv("OMPI_MCA_osc", "^ucx", 0);
      if (is_launched)
        return;
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
      setenv("OMPI_MCA_btl", "self", 0);
    }



    // Newer versions of deal.II hand the command line to PETSc, which this
    // program does not use, and PETSc would list what it does not know.
    void silence_petsc()
    {
      setenv("PETSC_OPTIONS", "-options_left no", /*overwrite=*/0);
    }



    // The blocks of a sparse factorization are too small for several threads of
    // OpenBLAS, which wait for each other most of the time. Other BLAS have no
    // such function.
    void use_one_thread_of_blas()
    {
      for (const char *variable : {"OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"})
        if (std::getenv(variable) != nullptr)
          return;
      if (void *function = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
        reinterpret_cast<void (*)(int)>(function)(1);
    }



    // CHOLMOD asks for four threads of OpenMP whatever the environment says,
    // for loops that are too short for them: they double its time. Without a
    // level of parallel regions it gets one.
    void use_one_thread_of_openmp()
    {
      const char *n_threads = std::getenv("OMP_NUM_THREADS");
      if (n_threads != nullptr && std::string(n_threads) != "1")
        return;
      if (void *function = dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"))
        reinterpret_cast<void (*)(int)>(function)(0);
    }



    // All files are read before the first one is computed: a wrong entry in the
    // last one should not cost the time of the others.
    int run(const CommandLine &line, const SolveCase &solve)
    {
      const bool is_first_rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
      std::vector<Parameters::All>  cases(line.files.size());
      std::vector<ParameterHandler> handlers(line.files.size());
      for (unsigned int i = 0; i < cases.size(); ++i)
        {
          read_parameters(line.files[i], line.overrides, handlers[i], cases[i]);
          cases[i].n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
          cases[i].restart = line.restart;
          if (line.verbose)
            cases[i].output.screen = Parameters::Screen::full;
          else if (line.quiet &&
                   cases[i].output.screen != Parameters::Screen::none)
            cases[i].output.screen = Parameters::Screen::table;
          cases[i].check();
          if (line.restart && has_converged(cases[i].directory()))
            throw InputError("the run in '" + cases[i].directory().string() +
                               "' has converged: it has nothing to go on from",
                             "command line, --restart",
                             "leave out --restart to compute it anew");
        }
      note_signals();

      std::set<std::filesystem::path> directories;
      for (const Parameters::All &a_case : cases)
        {
          bool is_new = directories.insert(a_case.directory()).second;
          if (asks_for_refined(a_case))
            is_new =
              directories.insert(refined_case(a_case).directory()).second &&
              is_new;
          if (!is_new)
            throw InputError(
              "two cases have the name '" + a_case.name +
                "', and the same directory for their results",
              "command line",
              "rename one of the files, or run them one by one with "
              "another Output/Directory");
        }

      for (unsigned int i = 0; i < cases.size(); ++i)
        {
          mesh_cad_file(cases[i], handlers[i], MPI_COMM_WORLD);
          add_automatic_pairs(cases[i]);
        }

      std::vector<RunSummary> summaries;
      for (unsigned int i = 0; i < cases.size(); ++i)
        {
          summaries.push_back(run_case(cases[i], handlers[i], solve));
          if (summaries.back().interrupted)
            break;
        }

      if (cases.front().output.screen != Parameters::Screen::none &&
          is_first_rank)
        print_table(std::cout, summaries);

      int status = 0;
      for (const RunSummary &summary : summaries)
        if (summary.interrupted)
          return 5;
        else if (!summary.converged)
          status = 3;
        else if (!summary.passed() && status == 0)
          status = 1;
      return status;
    }
  } // namespace



  int run_application(int argc, char **argv, const SolveCase &solve)
  {
    // Calls that compute nothing need no MPI.
    const std::string first = argc > 1 ? argv[1] : "";
    if (first == "--help")
      {
        print_help(std::cout);
        return 0;
      }
    if (first == "--version")
      {
        std::cout << program_version() << std::endl;
        return 0;
      }
    if (first == "--parameters")
      {
        print_parameters(std::cout);
        return 0;
      }

    spare_network();
    use_one_thread_of_blas();
    use_one_thread_of_openmp();
    silence_petsc();
    const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    try
      {
        return run(parse_command_line(argc, argv), solve);
      }
    catch (const InputError &error)
      {
        // All processes read the same.
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
          std::cerr << error.what() << std::endl;
        return 2;
      }
    catch (const std::exception &error)
      {
        end_all_ranks(MPI_COMM_WORLD, error);
        std::cerr << "The program failed; this is an error of its own:\n"
                  << error.what() << std::endl;
        return 4;
      }
  }
} // namespace Contact
