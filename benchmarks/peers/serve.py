"""The peers' end of the line: answers the commands of run.py on stdin, one line of JSON on stdout each.

`versions`, `time PHASE N` (N ticks, [ns] each), `solve PHASE` (motion, torque and wrenches at every state),
`model` (what the peer's rigid-body library makes of the URDF), `plan` (planning times [ns]).
"""

import json
import sys
import time


def serve(peer):
    """Answer until stdin ends.

    `peer` has `states[phase]`, `load(phase, k)` (state and references in, not timed), `tick(phase)` (timed: state in,
    torque and acceleration out), `result(phase)`, and for each further command a method without arguments.
    """
    for line in sys.stdin:
        command, *arguments = line.split()
        if command == "time":
            phase, answer = arguments[0], []
            for k in range(int(arguments[1])):
                peer.load(phase, k % len(peer.states[phase]))
                start = time.perf_counter_ns()
                peer.tick(phase)
                answer.append(time.perf_counter_ns() - start)
        elif command == "solve":
            phase, answer = arguments[0], []
            for k in range(len(peer.states[phase])):
                peer.load(phase, k)
                peer.tick(phase)
                answer.append(peer.result(phase))
        else:
            answer = getattr(peer, command)()
        print(json.dumps(answer), flush=True)
