#pragma once

#include "app/cli/command.h"

/// Every command of the program, each made in the source that is named after it.
namespace app {

/// simulate SCENE: builds the scene, runs it, records a take and a report.
Command simulateCommand();
/// resume TAKE: goes on from the last checkpoint of a run that was killed, or past the end of one that was
/// not, bit for bit as the unbroken run would have.
Command resumeCommand();
/// info FILE [--json]: what is in a scene, a take or a network file.
Command infoCommand();
/// render TAKE --out FILE: ray-traced pictures and films.
Command renderCommand();
/// export TAKE --format NAME --out FILE: a take's frames for other programs.
Command exportCommand();
/// import-lammps DUMP --scene SCENE --take FILE: a run of LAMMPS brought back as a take.
Command importLammpsCommand();
/// sweep SCENE --vary PATH=A,B,C ... --out FOLDER [--jobs N] [--slurm]
Command sweepCommand();
/// calibrate MATERIAL: the threshold at which a material breaks well.
Command calibrateCommand();
/// bench throughput|scaling|accuracy|stability|skip|all
Command benchCommand();

}  // namespace app
