#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A study of mdana as a job array of SLURM: one task a job, queued again when its time is over, from where it stopped.
#
#   mdana plan --tasks runs/study.toml                      how many tasks are sensible, their time and memory
#   sbatch --array=1-16 sbatch.sh runs/study.toml report 16
#   mdana merge runs/study.toml -o report                   when they are done; lists what is missing
#
# MDANA is the program, if it is not on the PATH.
#SBATCH --job-name=mdana
#SBATCH --cpus-per-task=2
#SBATCH --mem=4G
#SBATCH --time=01:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=mdana-%A-%a.log

if [ $# -ne 3 ]; then
  echo "usage: sbatch --array=1-M sbatch.sh STUDY OUT M" >&2
  exit 2
fi

threads=${SLURM_CPUS_PER_TASK:-1}
"${MDANA:-mdana}" run "$1" -o "$2" --of "$3" --task "$SLURM_ARRAY_TASK_ID" --threads "$threads" --jobs "$threads" &
mdana=$!
trap 'kill -USR1 "$mdana"' USR1 TERM

wait "$mdana"
code=$?
while [ "$code" -eq 138 ] || [ "$code" -eq 143 ]; do  # the signal ended the waiting, not yet mdana
  wait "$mdana"
  code=$?
done
if [ "$code" -eq 75 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
exit "$code"
