#!/usr/bin/env python3
"""Medians of bench_kernels, one thread, appended to a csv and printed as a Markdown table.

    kernels.py BENCH_KERNELS CSV

BENCH_KERNELS is built by cmake -DEPAFI_BENCHMARKS=ON (Debian's libbenchmark-dev).
"""
import csv
import datetime
import json
import os
import subprocess
import sys


def medians(program):
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    environment.setdefault("OPENBLAS_CORETYPE", "SkylakeX")
    text = subprocess.run(
        [program, "--benchmark_format=json", "--benchmark_min_time=0.2",
         "--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"],
        env=environment, check=True, stdout=subprocess.PIPE, universal_newlines=True).stdout
    return [run for run in json.loads(text)["benchmarks"]
            if run["aggregate_name"] == "median"]


def cpu():
    with open("/proc/cpuinfo") as file:
        return next((line.split(":")[1].strip() for line in file
                     if line.startswith("model name")), "unknown")


def main():
    program, path = sys.argv[1:]
    isNew = not os.path.exists(path)
    core = os.environ.get("OPENBLAS_CORETYPE", "SkylakeX")
    print("| kernel | CPU time |\n|---|---:|")
    with open(path, "a", newline="") as file:
        writer = csv.writer(file)
        if isNew:
            writer.writerow(["date", "cpu", "blas_core", "kernel", "cpu_time", "unit"])
        for run in medians(program):
            name = run["run_name"]
            writer.writerow([datetime.date.today().isoformat(), cpu(), core, name,
                             "%.4g" % run["cpu_time"], run["time_unit"]])
            print("| %s | %.4g %s |" % (name, run["cpu_time"], run["time_unit"]))


if __name__ == "__main__":
    main()
