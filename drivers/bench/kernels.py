#!/usr/bin/env python3
"""Medians of bench_kernels, one thread, appended to a csv and printed as a Markdown table.

    kernels.py BENCH_KERNELS CSV

BENCH_KERNELS is built by cmake -DEPAFI_BENCHMARKS=ON (Debian's libbenchmark-dev).
"""
import datetime
import json
import os
import subprocess
import sys

from study_tables import append, markdown


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
    runs = medians(program)
    print(markdown(["kernel", "CPU time"], [
        [run["run_name"], "%.4g %s" % (run["cpu_time"], run["time_unit"])] for run in runs]))
    append(path, [{
        "date": datetime.date.today().isoformat(), "cpu": cpu(),
        "blas_core": os.environ.get("OPENBLAS_CORETYPE", "SkylakeX"), "kernel": run["run_name"],
        "cpu_time": "%.4g" % run["cpu_time"], "unit": run["time_unit"]} for run in runs])


if __name__ == "__main__":
    main()
