/** What was copied as files: those that were chosen in a folder, or the text of a project. */
export function pastedFiles(data: {files: Iterable<File>; getData(format: string): string}): File[] {
  const files = [...data.files];
  if (files.length > 0) return files;
  const text = data.getData('text/plain').trim();
  return text.startsWith('{') ? [new File([text], 'project.snug.json')] : [];
}
