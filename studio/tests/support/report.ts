interface Report {
  findings: {code: string}[];
  workshop?: {figures: {label: string}[]};
}

/** What a report says wherever it was made: not how long it took, nor how firmly bricks hold, which takes a solver that a
 *  page has not. */
export function placeless(text: string): string {
  const report = JSON.parse(text) as Report;
  const findings = report.findings.filter(({code}) => !/^bricks_(overloaded|loose|fall|unchecked)$/.test(code));
  const figures = report.workshop?.figures.filter(({label}) => !/^(Lower half|Lid), /.test(label));
  return JSON.stringify({...report, findings, workshop: {...report.workshop, figures}, timing_ms: null});
}
