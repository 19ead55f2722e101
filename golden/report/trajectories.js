export function make_trajectories() { return null; }
