#pragma once

#include <string>
#include <vector>

#include "tests/habits/tree.h"

/// The habits of the source tree (docs/architecture.md) as functions that find where it breaks them.
namespace habits {

/// One place where the tree breaks a habit.
struct Offence {
  std::string file;
  std::size_t line = 0;  ///< from 1; 0: the file as a whole
  std::string what;      ///< one sentence without a full stop

  std::string text() const;
};

/// Top-level folders are app, docs, findings, modeling, resources, sim, tests, ui and .ci.
std::vector<Offence> strayFolders(const std::vector<File>& tree);
/// sim <- modeling <- ui <- app: a room includes itself and the rooms before it, by paths from the root.
std::vector<Offence> includesAgainstTheArrows(const std::vector<File>& tree);
/// The folders of sim, modeling and ui form a ladder each: a folder includes itself and those before it.
std::vector<Offence> includesAgainstTheLadder(const std::vector<File>& tree);
/// Each library is used from one room on: no Qt in sim or modeling, no JSON in sim, and so on.
std::vector<Offence> librariesInTheWrongRoom(const std::vector<File>& tree);
/// Loops run in parallel by sim/base/parallel.h, which the thread sanitizer can follow.
std::vector<Offence> parallelLoopsOfTheirOwn(const std::vector<File>& tree);
/// Work that is left is no comment in the code.
std::vector<Offence> notesToSelf(const std::vector<File>& tree);
/// Rules are cited by the section that states them, not by codes such as a letter and a number, which nobody
/// can look up.
std::vector<Offence> codesForRules(const std::vector<File>& tree);
/// The member functions of a class that a header declares are defined in one source.
std::vector<Offence> cutClasses(const std::vector<File>& tree);
std::vector<Offence> longFiles(const std::vector<File>& tree, std::size_t mostLines);
/// app/run, tests/run and .ci/run are there; whatever begins with #! may be executed, and so may
/// findings/*.sh.
std::vector<Offence> scriptsThatDoNotRun(const std::vector<File>& tree);
std::vector<Offence> headersWithoutGuard(const std::vector<File>& tree);
/// Sources are listed by hand: a forgotten one would be a test that never runs.
std::vector<Offence> sourcesNobodyBuilds(const std::vector<File>& tree);

}  // namespace habits
