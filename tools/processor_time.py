"""Processor time, shared by the Python tools."""

import resource


def processor_s():
    """Processor time of this process and of its programs that have ended."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)
